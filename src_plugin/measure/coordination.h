#pragma once

namespace encased_column {

/// Contacts counted over a specimen; a contact of two grains has two ends, one with a wall has one.
struct ContactCount {
  double grains = 0.0;
  double ends = 0.0;             ///< of all contacts
  double without_contact = 0.0;  ///< grains that touch nothing
  double with_one_contact = 0.0;
};

/// Mean number of contacts per grain [-].
inline double coordination_number(const ContactCount& n)
{
  return n.grains > 0.0 ? n.ends / n.grains : 0.0;
}

/// Mean number of contacts [-] per grain that bears load: grains with none or one contact and
/// those contacts left out.
/// Source: Thornton (2000), Geotechnique 50, 43-53, "mechanical coordination number".
inline double mechanical_coordination_number(const ContactCount& n)
{
  const double bearing = n.grains - n.without_contact - n.with_one_contact;
  return bearing > 0.0 ? (n.ends - n.with_one_contact) / bearing : 0.0;
}

}  // namespace encased_column
