// No cohesion: see style_surface_model.h.
