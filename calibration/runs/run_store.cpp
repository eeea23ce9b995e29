// SPDX-License-Identifier: GPL-2.0-only
#include "runs/run_store.h"

#include "core/input_error.h"
#include "runner/text_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace encased_column {

namespace {

const char* const tables = R"(
create table if not exists identity (text text not null);
create table if not exists points (id integer primary key, stage text, round integer,
  repeats integer);
create table if not exists coordinates (point integer references points, parameter integer,
  share real, primary key (point, parameter));
create table if not exists runs (point integer references points, repeat integer, name text,
  problem text, seconds real, curve text, primary key (point, repeat, name));
create table if not exists results (point integer, repeat integer, name text, quantity text,
  value real, primary key (point, repeat, name, quantity));
)";

/// The first lines that are not the same.
std::pair<std::string, std::string> difference(const std::string& a, const std::string& b)
{
  std::istringstream one(a), other(b);
  for (std::string x, y;;) {
    const bool more_x = static_cast<bool>(std::getline(one, x)),
               more_y = static_cast<bool>(std::getline(other, y));
    if (!more_x && !more_y) return {"", ""};
    if (!more_x) x = "nothing";
    if (!more_y) y = "nothing";
    if (x != y) return {x, y};
  }
}

}  // namespace

RunStore::RunStore(const std::filesystem::path& file)
try : database_(std::make_unique<SQLite::Database>(file.string(),
                                                   SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                                                   5000)) {
  database_->exec("pragma journal_mode = wal");
  database_->exec(tables);
} catch (const SQLite::Exception& problem) {
  throw InputError("the runs must be kept in a file of SQLite that can be written, found '" +
                   shown(file) + "' refused (" + problem.what() +
                   "), free it or choose another --out");
}

RunStore::~RunStore() = default;

void RunStore::identify(const std::string& identity)
{
  SQLite::Statement query(*database_, "select text from identity");
  if (!query.executeStep()) {
    SQLite::Statement keep(*database_, "insert into identity values (?)");
    keep.bind(1, identity);
    keep.exec();
    return;
  }
  const auto [there, now] = difference(query.getColumn(0).getString(), identity);
  if (there != now)
    throw InputError(
        "a calibration goes on with the same parameters, cases and variables, found '" + now +
        "' where its runs were made with '" + there + "', give it another 'name' or --out");
}

void RunStore::add_points(const std::vector<StoredPoint>& points)
{
  SQLite::Transaction whole(*database_);
  int id = database_->execAndGet("select coalesce(max(id) + 1, 0) from points").getInt();
  for (const StoredPoint& one : points) {
    SQLite::Statement add(*database_, "insert into points values (?, ?, ?, ?)");
    add.bind(1, id);
    add.bind(2, one.stage);
    add.bind(3, one.round);
    add.bind(4, one.repeats);
    add.exec();
    for (Eigen::Index i = 0; i < one.point.size(); ++i) {
      SQLite::Statement place(*database_, "insert into coordinates values (?, ?, ?)");
      place.bind(1, id);
      place.bind(2, static_cast<int>(i));
      place.bind(3, one.point[i]);
      place.exec();
    }
    ++id;
  }
  whole.commit();
}

std::vector<StoredPoint> RunStore::points() const
{
  std::vector<StoredPoint> all;
  SQLite::Statement query(*database_, "select id, stage, round, repeats from points order by id");
  while (query.executeStep())
    all.push_back({query.getColumn(0).getInt(),
                   query.getColumn(1).getString(),
                   query.getColumn(2).getInt(),
                   query.getColumn(3).getInt(),
                   {}});
  for (StoredPoint& one : all) {
    SQLite::Statement shares(*database_,
                             "select share from coordinates where point = ? order by parameter");
    shares.bind(1, one.id);
    std::vector<double> found;
    while (shares.executeStep()) found.push_back(shares.getColumn(0).getDouble());
    one.point = Eigen::Map<Eigen::VectorXd>(found.data(), static_cast<Eigen::Index>(found.size()));
  }
  return all;
}

void RunStore::record(const RunKey& key, const RunResult& result)
{
  SQLite::Transaction whole(*database_);
  SQLite::Statement old(*database_,
                        "delete from results where point = ? and repeat = ? and name = ?");
  SQLite::Statement add(*database_, "insert or replace into runs values (?, ?, ?, ?, ?, ?)");
  for (SQLite::Statement* statement : {&old, &add}) {
    statement->bind(1, key.point);
    statement->bind(2, key.repeat);
    statement->bind(3, key.name);
  }
  add.bind(4, result.problem);
  add.bind(5, result.seconds);
  add.bind(6, nlohmann::json{result.strain, result.stress}.dump());
  old.exec();
  add.exec();
  for (const auto& [quantity, value] : result.values) {
    SQLite::Statement one(*database_, "insert into results values (?, ?, ?, ?, ?)");
    one.bind(1, key.point);
    one.bind(2, key.repeat);
    one.bind(3, key.name);
    one.bind(4, quantity);
    one.bind(5, value);
    one.exec();
  }
  whole.commit();
}

std::map<RunKey, RunResult> RunStore::runs() const
{
  std::map<RunKey, RunResult> all;
  SQLite::Statement query(*database_,
                          "select point, repeat, name, problem, seconds, curve from runs");
  while (query.executeStep()) {
    RunResult& one = all[{query.getColumn(0).getInt(), query.getColumn(1).getInt(),
                          query.getColumn(2).getString()}];
    one.problem = query.getColumn(3).getString();
    one.seconds = query.getColumn(4).getDouble();
    const auto curve = nlohmann::json::parse(query.getColumn(5).getString());
    one.strain = curve[0].get<std::vector<double>>();
    one.stress = curve[1].get<std::vector<double>>();
  }
  SQLite::Statement values(*database_, "select point, repeat, name, quantity, value from results");
  while (values.executeStep())
    all[{values.getColumn(0).getInt(), values.getColumn(1).getInt(),
         values.getColumn(2).getString()}]
        .values[values.getColumn(3).getString()] = values.getColumn(4).getDouble();
  return all;
}

long RunStore::run_count() const
{
  return database_->execAndGet("select count(*) from runs").getInt64();
}

void RunStore::forget_failed()
{
  database_->exec("delete from runs where problem <> ''");
}

}  // namespace encased_column
