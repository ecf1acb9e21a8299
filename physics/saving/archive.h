#pragma once

#include <state/member_list.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

// Serialization of a world. Each type lists its members once, in `members(io, self)`. The writer
// and the reader both use that list, so saving and restoring cannot differ. Types that own no
// memory are copied byte by byte, including padding, so no data that the next step might use can be
// missing.

namespace fettle::physics::detail {

/// True for types that may be copied byte by byte.
template <class T>
inline constexpr bool bytewise = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// Writes the data, or only counts their bytes (`ArchiveSize`).
template <class Sink>
class ArchiveOutput {
  public:
    explicit ArchiveOutput(Sink sink) : sink_(sink) {}

    template <class T>
    void operator()(const T& value) {
        if constexpr (ListsMembers<const T, ArchiveOutput>) {
            T::members(*this, value);
        } else {
            static_assert(bytewise<T>, "it owns memory: list its members");
            sink_(&value, sizeof value);
        }
    }
    template <class T>
    void operator()(const std::vector<T>& list) {
        (*this)(uint64_t{list.size()});
        if constexpr (ListsMembers<const T, ArchiveOutput>) {
            for (const T& element : list) (*this)(element);
        } else {
            static_assert(bytewise<T>, "it owns memory: list its members");
            sink_(list.data(), list.size() * sizeof(T));
        }
    }
    template <class T, std::size_t n>
    void operator()(const std::array<std::vector<T>, n>& lists) {
        each_of(*this, lists);
    }
    void operator()(const Events& events) { event_members(*this, events); }

  private:
    Sink sink_;
};

struct AppendBytes {
    std::vector<std::byte>& out;
    void operator()(const void* from, std::size_t size) const {
        const auto* bytes = static_cast<const std::byte*>(from);
        out.insert(out.end(), bytes, bytes + size);
    }
};
struct CountBytes {
    std::size_t& sum;
    void operator()(const void*, std::size_t size) const { sum += size; }
};

class ArchiveWriter : public ArchiveOutput<AppendBytes> {
  public:
    explicit ArchiveWriter(std::vector<std::byte>& out) : ArchiveOutput(AppendBytes{out}) {}
};
/// Counts the bytes that a writer would write, so that memory is allocated once.
class ArchiveSize : public ArchiveOutput<CountBytes> {
  public:
    explicit ArchiveSize(std::size_t& sum) : ArchiveOutput(CountBytes{sum}) {}
};

/// Throws std::invalid_argument if the data end too early.
class ArchiveReader {
  public:
    explicit ArchiveReader(std::span<const std::byte> in) : in_(in) {}

    template <class T>
    void operator()(T& value) {
        if constexpr (ListsMembers<T, ArchiveReader>)
            T::members(*this, value);
        else
            raw(&value, 1, sizeof value);
    }
    template <class T>
    void operator()(std::vector<T>& list) {
        uint64_t count = 0;
        (*this)(count);
        // Every element takes at least one byte, so a count cannot exceed the number of remaining
        // bytes.
        const std::size_t least = ListsMembers<T, ArchiveReader> ? 1 : sizeof(T);
        if (count > in_.size() / least) throw std::invalid_argument("the bytes end too early");
        list.clear();
        list.resize(std::size_t(count));
        if constexpr (ListsMembers<T, ArchiveReader>)
            for (T& element : list) (*this)(element);
        else
            raw(list.data(), list.size(), sizeof(T));
    }
    template <class T, std::size_t n>
    void operator()(std::array<std::vector<T>, n>& lists) {
        each_of(*this, lists);
    }
    void operator()(Events& events) { event_members(*this, events); }
    bool at_end() const { return in_.empty(); }

  private:
    void raw(void* to, std::size_t count, std::size_t size) {
        if (in_.size() / size < count) throw std::invalid_argument("the bytes end too early");
        if (count > 0) std::memcpy(to, in_.data(), count * size);
        in_ = in_.subspan(count * size);
    }
    std::span<const std::byte> in_;
};

}  // namespace fettle::physics::detail
