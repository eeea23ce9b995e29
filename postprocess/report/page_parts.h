// SPDX-License-Identifier: GPL-2.0-only
#pragma once

#include "drawing/figure.h"
#include "drawing/picture_data.h"
#include "reading/case_run.h"
#include "tables/evaluation.h"
#include "tables/text_layout.h"

#include <filesystem>
#include <string>
#include <vector>

#include <kainjow/mustache.hpp>

namespace encased_column {

/// What a template is filled with.
using PageData = kainjow::mustache::data;

/// A table of a page: `rows`, of which the first holds the headings. Columns of numbers stand to
/// the right; where `group` names a column, its words become headings between the rows.
PageData table_data(const std::string& id, const std::string& caption, const Rows& rows,
                    const std::string& group = {});

/// `rows` without the column called `heading`.
Rows without(const Rows& rows, const std::string& heading);

/// The figures with their charts drawn, of runs with `variables`. Needs a display.
PageData figures_data(const std::vector<Figure>& figures, const std::string& variables);

/// Fills the part of a page that says whether `sets` agree with the laboratory: a sentence, a row
/// of numbers and one figure. Needs a display.
void set_agreement(PageData& page, const std::vector<SetResult>& sets, const Targets& targets,
                   const std::string& variables);

/// A 3-D picture and what it shows.
struct Picture {
  std::string name;   ///< of its kind
  std::string title;  ///< in a word or two
  PictureData image;
  std::string caption, alternative;
  bool wide;  ///< takes a row of its own
};
PageData pictures_data(const std::vector<Picture>& pictures);

/// A list of objects with one text `name` each.
PageData list_of(const std::string& name, const std::vector<std::string>& texts);

/// `page`, a template of page_templates, filled with `data` and the parts it names. Throws
/// std::logic_error if the template is malformed.
std::string filled(const char* page, PageData data);

/// The 3-D pictures of `run` that are in `folder`, made smaller to be `width` [px] wide at most.
std::vector<Picture> pictures_of(const CaseRun& run, const std::filesystem::path& folder,
                                 int width);

/// Each figure of the study's results and which of `figures` and `pictures` of the run `test`
/// stand beside it, or why none does; below a row of headings.
Rows counterpart_rows(const TestResult& test, const std::vector<Figure>& figures,
                      const std::vector<Picture>& pictures);

}  // namespace encased_column
