// SPDX-License-Identifier: GPL-2.0-only
#pragma once

namespace encased_column {

/// Reaches a private member of the host without a change to it: explicit instantiation may name
/// private members. A Tag of this namespace says the member's `type` and declares
/// `friend type reveal(Tag)`; after `template struct Reveal<Tag, &Class::member>;` in one source
/// `object.*reveal(Tag())` is the member. No namespace without a name can hold a Tag: this template
/// defines the function that the Tag declares, and both must mean the same one.
template <typename Tag, typename Tag::type member>
struct Reveal {
  friend typename Tag::type reveal(Tag) { return member; }
};

}  // namespace encased_column
