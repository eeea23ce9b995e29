// SPDX-License-Identifier: GPL-2.0-only
// The linear law stands in contact/model_linear.h as a whole contact model.
