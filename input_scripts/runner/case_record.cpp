// SPDX-License-Identifier: GPL-2.0-only
#include "runner/case_record.h"

#include "core/input_error.h"
#include "runner/text_file.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>

namespace encased_column {

namespace {

using Json = nlohmann::ordered_json;

/// A number where `text` spells one that JSON has the same way, else the text.
Json value_of_text(const std::string& text)
{
  static const std::regex number(R"(-?(0|[1-9]\d*)(\.\d+)?([eE][-+]?\d+)?)");
  if (text.size() < 40 && std::regex_match(text, number)) {
    const Json parsed = Json::parse(text, nullptr, false);
    if (parsed.is_number_float()) {
      const double x = parsed.get<double>();  // 50e3 is 50000 to who reads it, not 50000.0
      if (std::abs(x) < 1e15 && x == std::floor(x)) return static_cast<std::int64_t>(x);
    }
    if (parsed.is_number()) return parsed;
  }
  return text;
}

Json object_of(const Settings& settings)
{
  Json object = Json::object();
  for (const auto& [name, value] : settings) object[name] = value_of_text(value);
  return object;
}

Settings settings_of(const Json& object)
{
  if (!object.is_object()) throw InputError("variables that are no object");
  Settings settings;
  for (const auto& [name, value] : object.items()) {
    if (!value.is_number() && !value.is_string())
      throw InputError("'" + name.substr(0, 60) + "', which is neither number nor text");
    settings.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return settings;
}

std::string text_of(const Json& json, const char* name, const std::string& otherwise = "")
{
  const auto found = json.find(name);
  if (found == json.end() && !otherwise.empty()) return otherwise;
  if (found == json.end() || !found->is_string())
    throw InputError("no text '" + std::string(name) + "'");
  return found->get<std::string>();
}

CaseRecord record_of(const Json& json)
{
  if (json.is_discarded()) throw InputError("something that is not JSON");
  if (!json.is_object()) throw InputError("no object");
  CaseRecord record;
  record.id = text_of(json, "id");
  record.deck = text_of(json, "deck");
  if (record.id.empty() || record.deck.empty()) throw InputError("an empty id or deck");
  record.title = text_of(json, "title", record.id);
  if (json.contains("reproduces")) record.reproduces = text_of(json, "reproduces");
  if (json.contains("variables")) record.used = settings_of(json["variables"]);
  if (json.contains("asked"))
    record.asked = settings_of(json["asked"]);
  else if (json.contains("variables"))
    record.asked = record.used;
  else
    throw InputError("no object 'variables'");
  return record;
}

}  // namespace

const std::string* value_in(const Settings& settings, const std::string& name)
{
  for (const Setting& setting : settings)
    if (setting.first == name) return &setting.second;
  return nullptr;
}

CaseRecord read_case_record(const std::filesystem::path& file)
{
  const std::string text = read_text_file(file, "'" + shown(file) + "'");
  try {
    // Brackets within brackets take the stack: a case has two levels.
    const auto shallow = [](int level, Json::parse_event_t, Json&) { return level < 8; };
    return record_of(Json::parse(text, shallow, false));
  } catch (const InputError& problem) {
    throw InputError("'" + shown(file) +
                     "' must hold the texts id and deck and the object variables, found " +
                     problem.what() + ", run the case again");
  }
}

void write_case_record(const std::filesystem::path& file, const CaseRecord& record)
{
  Json json;
  json["id"] = record.id;
  json["deck"] = record.deck;
  json["title"] = record.title;
  json["reproduces"] = record.reproduces;
  json["asked"] = object_of(record.asked);
  if (!record.used.empty()) json["variables"] = object_of(record.used);
  write_text_file(file, json.dump(1) + "\n");
}

}  // namespace encased_column
