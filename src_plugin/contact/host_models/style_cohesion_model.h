// SPDX-License-Identifier: GPL-2.0-only
// No cohesion: see style_surface_model.h.
