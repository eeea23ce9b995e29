// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "core/vec3.h"

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace encased_column {

/// One keyword of a style, as the deck writes it and the user page lists it.
struct Keyword {
  std::string name;
  int values;            ///< words that follow it
  std::string unit;      ///< "-" where there is none
  std::string meaning;   ///< as on the user page
  bool repeats = false;  ///< may stand more than once
};

/// What a deck gave for the keywords of one table; every accessor throws InputError. The accessors
/// note which value they handed out where the deck gave none, so that understood() can tell.
class Options {
 public:
  bool has(const std::string& keyword) const { return found_.count(keyword) > 0; }

  double number(const std::string& keyword) const;
  double number(const std::string& keyword, double otherwise) const;
  double positive(const std::string& keyword) const;
  double positive(const std::string& keyword, double otherwise) const;
  double not_negative(const std::string& keyword, double otherwise) const;
  double between(const std::string& keyword, double low, double high) const;
  double between(const std::string& keyword, double low, double high, double otherwise) const;
  long integer(const std::string& keyword, long low) const;
  long integer(const std::string& keyword, long low, long otherwise) const;
  Vec3 vector(const std::string& keyword) const;
  std::string word(const std::string& keyword) const;
  std::string word(const std::string& keyword, const std::string& otherwise) const;
  /// The word given, which must be one of `allowed`.
  std::string choice(const std::string& keyword, const std::vector<std::string>& allowed) const;
  std::string choice(const std::string& keyword, const std::vector<std::string>& allowed,
                     const std::string& otherwise) const;
  /// All words given for each time the keyword stands, in order.
  const std::vector<std::vector<std::string>>& all(const std::string& keyword) const;

  /// Notes that `value` stands for `keyword` where the deck does not give it and no accessor above
  /// is asked with it.
  void assume(const std::string& keyword, const std::string& value) const;
  void assume(const std::string& keyword, double value) const;

  /// All that will be used, defaults included, in the order and the words of the table: "every 200,
  /// file history.csv".
  std::string understood() const;

 private:
  friend class KeywordTable;
  std::vector<std::string> keywords_;  ///< of the table
  std::map<std::string, std::vector<std::vector<std::string>>> found_;
  mutable std::map<std::string, std::string> assumed_;
};

/// The keywords of a style, declared once: the reader, the message for an unknown keyword and the
/// check of the user page all use the same table.
class KeywordTable {
 public:
  KeywordTable(std::initializer_list<Keyword> keywords) : keywords_(keywords) {}
  /// Keywords that several styles share, followed by a style's own.
  KeywordTable(const std::vector<Keyword>& shared, std::initializer_list<Keyword> own)
      : keywords_(shared)
  {
    keywords_.insert(keywords_.end(), own.begin(), own.end());
  }

  /// Reads `words`, keyword by keyword; throws InputError at the first it does not know, at a
  /// missing value, and at a keyword that stands twice and may not.
  Options read(const std::vector<std::string>& words) const;

  /// Reads a style's words in the host's form, of which the first `skip` are not keywords
  /// ("fix ID group style" are three by the time the host calls).
  Options read(int narg, char** arg, int skip = 3) const;

  const std::vector<Keyword>& keywords() const { return keywords_; }
  /// The names, separated by commas.
  std::string names() const;

 private:
  std::vector<Keyword>::const_iterator find(const std::string& name) const;

  std::vector<Keyword> keywords_;
};

}  // namespace encased_column
