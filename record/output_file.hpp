// A file that appears under its name when it is whole, and not before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/result.hpp"

namespace mayfly::record {

// Writes to `path` + ".partial"; commit() gives it its name, replacing what was there. Destroyed without
// commit() it leaves nothing behind. A path that is a device or a pipe (/dev/stdout) is written directly,
// there being no name to give.
class OutputFile {
 public:
  // Errors: a folder that does not exist or that may not be written to is the caller's, a full disk the
  // environment's.
  static Result<OutputFile> create(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;
  ~OutputFile();

  // All of `text` or nothing: what could be written of it is taken back. On failure error_number() says why,
  // and later calls may succeed (a disk may have room again).
  bool write(std::string_view text) noexcept;
  // The errno of the last write that failed; 0 where none did.
  int error_number() const noexcept { return error_number_; }

  // Nothing may be written afterwards.
  Result<void> commit();
  // Gives up, but leaves what there is under the temporary name, which is returned.
  std::filesystem::path leave_partial() noexcept;

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  OutputFile(std::filesystem::path path, std::filesystem::path temporary, int descriptor) noexcept;
  void close() noexcept;

  std::filesystem::path path_;
  std::filesystem::path temporary_;  // empty for a device
  int descriptor_ = -1;
  int error_number_ = 0;
  std::int64_t written_ = 0;
};

// The whole file at once.
Result<void> write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace mayfly::record
