#include "record/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace mayfly::record {
namespace {

tl::unexpected<Error> file_error(const std::filesystem::path& path, int number) {
  const bool caller = number == ENOENT || number == ENOTDIR || number == EISDIR || number == EACCES ||
                      number == EPERM || number == EROFS || number == ENAMETOOLONG || number == ELOOP;
  const auto text = "cannot write '" + path.string() + "': " + std::generic_category().message(number);
  return fail(caller ? Cause::kCaller : Cause::kEnvironment, text);
}

bool is_device(const std::filesystem::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

}  // namespace

Result<OutputFile> OutputFile::create(const std::filesystem::path& wanted) {
  if (is_device(wanted)) {
    const int descriptor = ::open(wanted.c_str(), O_WRONLY | O_CLOEXEC);
    return descriptor < 0 ? file_error(wanted, errno)
                          : Result<OutputFile>(OutputFile(wanted, {}, descriptor));
  }
  std::error_code failure;
  // Through a symbolic link: the link stays, its target is replaced.
  auto path = std::filesystem::weakly_canonical(wanted, failure);
  if (failure) {
    return file_error(wanted, failure.value());
  }
  if (std::filesystem::is_directory(path, failure)) {
    return file_error(wanted, EISDIR);
  }
  auto temporary = path;
  temporary += ".partial";
  const int descriptor =
      ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor < 0) {
    return file_error(wanted, errno);
  }
  return OutputFile(std::move(path), std::move(temporary), descriptor);
}

OutputFile::OutputFile(std::filesystem::path path, std::filesystem::path temporary, int descriptor) noexcept
    : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      error_number_(other.error_number_),
      written_(other.written_) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(temporary_, other.temporary_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(error_number_, other.error_number_);
  std::swap(written_, other.written_);
  return *this;
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) {
    close();
    if (!temporary_.empty()) {
      ::unlink(temporary_.c_str());
    }
  }
}

bool OutputFile::write(std::string_view text) noexcept {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor_, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      error_number_ = count < 0 ? errno : EIO;
      // Devices and pipes can't take anything back; for files a failure here shows again at the next write.
      if (!temporary_.empty() && ::ftruncate(descriptor_, written_) == 0) {
        ::lseek(descriptor_, written_, SEEK_SET);
      }
      return false;
    }
    done += static_cast<std::size_t>(count);
  }
  written_ += static_cast<std::int64_t>(text.size());
  return true;
}

Result<void> OutputFile::commit() {
  const int descriptor = std::exchange(descriptor_, -1);
  // Some file systems report a full disk only here.
  int number = ::close(descriptor) == 0 ? 0 : errno;
  if (number == 0 && !temporary_.empty() && ::rename(temporary_.c_str(), path_.c_str()) != 0) {
    number = errno;
  }
  if (number == 0) {
    return {};
  }
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
  }
  return file_error(path_, number);
}

std::filesystem::path OutputFile::leave_partial() noexcept {
  close();
  return std::move(temporary_);
}

void OutputFile::close() noexcept {
  ::close(std::exchange(descriptor_, -1));
}

Result<void> write_file(const std::filesystem::path& path, std::string_view text) {
  auto file = OutputFile::create(path);
  if (!file) {
    return fail(std::move(file.error()));
  }
  if (!file->write(text)) {
    return file_error(path, file->error_number());
  }
  return file->commit();
}

}  // namespace mayfly::record
