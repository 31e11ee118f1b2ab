#include "controller/link/segment.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <new>
#include <system_error>
#include <utility>

namespace mayfly::link {
namespace {

// A reader may be interrupted for as long as it takes to write three more before its copy is torn.
constexpr std::size_t kNewestSlots = 4;
constexpr std::size_t kEventSlots = 256;
constexpr int kSeals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
constexpr std::size_t kHeaderWords = sizeof(Header) / sizeof(Word);

std::string reason() {
  return std::generic_category().message(errno);
}

// FNV-1a (Fowler, Noll, Vo), over words and bytes.
class Hash {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      value_ = (value_ ^ static_cast<Word>(byte)) * 0x100000001b3U;
    }
  }
  void add(Word word) { add(std::as_bytes(std::span(&word, 1))); }
  Word value() const { return value_; }

 private:
  Word value_ = 0xcbf29ce484222325U;
};

Error mismatch(const std::string& what, Word found, Word wanted) {
  return {.cause = Cause::kEnvironment,
          .message = "shared memory: " + what + " is not this program's",
          .found = std::to_string(found),
          .wanted = std::to_string(wanted)};
}

Error not_ours(const std::string& found) {
  return {.cause = Cause::kEnvironment,
          .message = "this descriptor is no segment of a mayfly planner",
          .found = found,
          .wanted = "a sealed memory file"};
}

}  // namespace

Roster roster_of(std::span<const RobotInfo> robots) {
  Hash hash;
  for (const RobotInfo& robot : robots) {
    hash.add(std::as_bytes(std::span(robot.name)));
    hash.add(Word{0});  // so that "ab", "c" is not "a", "bc"
  }
  return {static_cast<std::uint32_t>(robots.size()), hash.value()};
}

Layout layout_of(const Roster& roster) {
  Layout layout;
  layout.wish = {kNewestSlots, bytes_of(wish_columns, roster.count)};
  layout.operators = {kNewestSlots, bytes_of(operator_columns, roster.count)};
  layout.view = {kNewestSlots, bytes_of(view_columns, roster.count)};
  layout.events = {kEventSlots, sizeof(Event)};
  layout.wish_at = kHeaderWords;
  layout.operators_at = layout.wish_at + layout.wish.words();
  layout.view_at = layout.operators_at + layout.operators.words();
  layout.events_at = layout.view_at + layout.view.words();
  layout.words = layout.events_at + layout.events.words();
  Hash hash;
  for (const Word word :
       {kVersion, Word{sizeof(Header)}, Word{roster.count}, roster.names, Word{layout.wish.bytes},
        Word{layout.operators.bytes}, Word{layout.view.bytes}, Word{layout.events.bytes}, Word{kNewestSlots},
        Word{kEventSlots}, Word{sizeof(WishHead)}, Word{sizeof(OperatorHead)}, Word{sizeof(ViewHead)},
        Word{sizeof(GuardReport)}}) {
    hash.add(word);
  }
  layout.hash = hash.value();
  return layout;
}

Segment::Handle::~Handle() {
  if (memory != nullptr) {
    ::munmap(memory, bytes);
  }
  if (descriptor >= 0) {
    ::close(descriptor);
  }
}

Result<void> Segment::Handle::map(std::size_t size) {
  void* mapped = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (mapped == MAP_FAILED) {
    return fail(Cause::kEnvironment, "shared memory cannot be mapped: " + reason());
  }
  memory = static_cast<std::byte*>(mapped);
  bytes = size;
  return {};
}

Result<Segment> Segment::create(const Roster& roster, Time epoch) {
  const Layout layout = layout_of(roster);
  const std::size_t bytes = layout.words * sizeof(Word);
  auto handle = std::make_unique<Handle>(::memfd_create("mayfly", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (handle->descriptor < 0 || ::ftruncate(handle->descriptor, static_cast<off_t>(bytes)) != 0 ||
      ::fcntl(handle->descriptor, F_ADD_SEALS, kSeals) != 0) {
    return fail(Cause::kEnvironment, "no shared memory: " + reason());
  }
  if (auto mapped = handle->map(bytes); !mapped) {
    return fail(std::move(mapped.error()));
  }
  auto* words = reinterpret_cast<SharedWord*>(handle->memory);
  for (std::size_t word = 0; word < layout.words; ++word) {
    new (words + word) SharedWord(0);
  }
  auto* header = new (handle->memory) Header{};
  header->magic = kMagic;
  header->version = kVersion;
  header->robots = roster.count;
  header->layout = layout.hash;
  header->bytes = bytes;
  header->epoch_ns = static_cast<Word>(epoch.count());
  return Segment(std::move(handle), roster, layout);
}

Result<Segment> Segment::attach(int descriptor, const Roster& roster) {
  auto handle = std::make_unique<Handle>(descriptor);
  struct stat file {};
  if (::fstat(descriptor, &file) != 0) {
    return fail(not_ours(reason()));
  }
  const int seals = ::fcntl(descriptor, F_GET_SEALS);
  if (seals < 0 || (seals & kSeals) != kSeals || static_cast<std::size_t>(file.st_size) < sizeof(Header)) {
    return fail(not_ours(seals < 0 ? "something else" : "one that is too small or can be shrunk"));
  }
  const auto size = static_cast<std::size_t>(file.st_size);
  if (auto mapped = handle->map(size); !mapped) {
    return fail(std::move(mapped.error()));
  }
  const Layout layout = layout_of(roster);
  Segment segment(std::move(handle), roster, layout);
  const Header& header = segment.header();
  if (header.magic.load() != kMagic) {
    return fail(not_ours("another file's first bytes"));
  }
  struct Row {
    const char* what;
    Word found, wanted;
  };
  const std::array<Row, 4> rows{
      Row{"the version", header.version.load(), kVersion},
      Row{"the number of robots", header.robots.load(), roster.count},
      Row{"the layout, or the names of the robots,", header.layout.load(), layout.hash},
      Row{"the size", size, layout.words * sizeof(Word)}};
  for (const Row& row : rows) {
    if (row.found != row.wanted) {
      return fail(mismatch(row.what, row.found, row.wanted));
    }
  }
  return segment;
}

Result<Word> take_lease(Header& header, SharedWord& lease, const std::string& what) {
  const auto ticks = std::chrono::steady_clock::now().time_since_epoch().count();
  const Word own = static_cast<Word>(::getpid()) << 32U | (static_cast<Word>(ticks) & 0xffffffffU) | 1U;
  Word holder = 0;
  if (!lease.compare_exchange_strong(holder, own)) {
    header.leases_refused.fetch_add(1, std::memory_order_relaxed);
    return fail({.cause = Cause::kEnvironment,
                 .message = "there is already a " + what + " on this link",
                 .found = "process " + std::to_string(holder >> 32U),
                 .wanted = "one at most"});
  }
  return own;
}

}  // namespace mayfly::link
