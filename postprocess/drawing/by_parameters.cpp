// SPDX-License-Identifier: GPL-2.0-only
#include "drawing/by_parameters.h"

#include <algorithm>
#include <iterator>

namespace encased_column {

namespace {

bool of_columns(const SetResult& set)
{
  return set.set == "column";
}

/// `sets` in groups of the same parameters, columns apart, in the order in which these come.
std::vector<std::vector<SetResult>> by_parameters(const std::vector<SetResult>& sets)
{
  std::vector<std::vector<SetResult>> groups;
  for (const SetResult& set : sets) {
    const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return group.front().parameters() == set.parameters() &&
             of_columns(group.front()) == of_columns(set);
    });
    if (known == groups.end())
      groups.push_back({set});
    else
      known->push_back(set);
  }
  return groups;
}

/// Adds `figure` to the one of its name, or else as a new one.
void add_panels(std::vector<Figure>& figures, Figure figure)
{
  const auto known = std::find_if(figures.begin(), figures.end(),
                                  [&](const Figure& f) { return f.name == figure.name; });
  if (known == figures.end())
    figures.push_back(std::move(figure));
  else
    std::move(figure.panels.begin(), figure.panels.end(), std::back_inserter(known->panels));
}

}  // namespace

std::vector<Figure> drawn_by_parameters(const std::vector<SetResult>& sets, const FigureMaker& make)
{
  std::vector<Figure> figures;
  const bool others = std::any_of(sets.begin(), sets.end(), std::not_fn(of_columns));
  for (const std::vector<SetResult>& group : by_parameters(sets)) {
    const std::string parameters = group.front().parameters();
    std::string name = others && of_columns(group.front()) ? ", columns" : "";
    if (!parameters.empty()) name += ", parameters " + parameters;
    for (Figure& figure : make(group)) {
      for (Panel& panel : figure.panels) panel.title += name;
      add_panels(figures, std::move(figure));
    }
  }
  return figures;
}

}  // namespace encased_column
