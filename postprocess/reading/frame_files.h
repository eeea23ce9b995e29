#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace encased_column {

/// The files a ParaView collection `collection` (.pvd) lists, by their time; of one time the last.
/// Throws InputError if it cannot be read or lists none.
std::map<double, std::filesystem::path> frame_files(const std::filesystem::path& collection);

/// Throws the InputError of a collection in which `found` was found, not files of points.
[[noreturn]] void refuse_collection(const std::filesystem::path& collection,
                                    const std::string& found);

}  // namespace encased_column
