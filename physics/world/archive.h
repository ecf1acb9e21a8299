#pragma once

#include <fettle/physics/events.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <vector>

// A world as bytes. Each type lists its members once, in `members(io, self)`; the writer and the
// reader both walk that list, so saving and restoring cannot differ. Whatever owns no memory is
// copied byte by byte: everything the next step might depend on, padding and all.

namespace fettle::physics::detail {

/// Has a `members` of its own.
template <class T, class Io>
concept ListsMembers = requires(Io& io, T& value) {
    std::remove_const_t<T>::members(io, value);
};

/// What may be copied byte by byte. Not `is_trivially_copyable`, which Eigen's vectors are not;
/// whoever owns memory has a destructor that does something.
template <class T>
inline constexpr bool bytewise = std::is_trivially_destructible_v<T> && !std::is_pointer_v<T>;

/// What happened, list by list.
template <class Io, class Happened>
void event_members(Io& io, Happened& e) {
    static_assert(sizeof(Events) == 9 * sizeof(std::vector<int>), "list the new member here");
    io(e.contact_begin), io(e.contact_persist), io(e.contact_end), io(e.contact_hit);
    io(e.sensor_begin), io(e.sensor_end), io(e.joint_broke);
    io(e.slept), io(e.woke);
}

/// How many bytes a writer would write: so that room is made once.
class ArchiveSize {
  public:
    template <class T>
    void operator()(const T& value) {
        if constexpr (ListsMembers<const T, ArchiveSize>)
            T::members(*this, value);
        else
            bytes_ += sizeof value;
    }
    template <class T>
    void operator()(const std::vector<T>& list) {
        bytes_ += sizeof(uint64_t);
        if constexpr (ListsMembers<const T, ArchiveSize>)
            for (const T& element : list) (*this)(element);
        else
            bytes_ += list.size() * sizeof(T);
    }
    template <class... T>
    void operator()(const std::tuple<T...>& tuple) {
        std::apply([this](const T&... each) { ((*this)(each), ...); }, tuple);
    }
    template <class T, std::size_t n>
    void operator()(const std::array<std::vector<T>, n>& lists) {
        for (const auto& list : lists) (*this)(list);
    }
    std::size_t bytes() const { return bytes_; }

  private:
    std::size_t bytes_ = 0;
};

class ArchiveWriter {
  public:
    explicit ArchiveWriter(std::vector<std::byte>& out) : out_(out) {}

    template <class T>
    void operator()(const T& value) {
        if constexpr (ListsMembers<const T, ArchiveWriter>) {
            T::members(*this, value);
        } else {
            static_assert(bytewise<T>, "it owns memory: list its members");
            raw(&value, sizeof value);
        }
    }
    template <class T>
    void operator()(const std::vector<T>& list) {
        (*this)(uint64_t{list.size()});
        if constexpr (ListsMembers<const T, ArchiveWriter>) {
            for (const T& element : list) (*this)(element);
        } else {
            static_assert(bytewise<T>, "it owns memory: list its members");
            raw(list.data(), list.size() * sizeof(T));
        }
    }
    template <class... T>
    void operator()(const std::tuple<T...>& tuple) {
        std::apply([this](const T&... each) { ((*this)(each), ...); }, tuple);
    }
    template <class T, std::size_t n>
    void operator()(const std::array<std::vector<T>, n>& lists) {
        for (const auto& list : lists) (*this)(list);
    }

  private:
    void raw(const void* from, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(from);
        out_.insert(out_.end(), bytes, bytes + size);
    }
    std::vector<std::byte>& out_;
};

/// Throws std::invalid_argument where the bytes end too early.
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
        // Every element takes a byte at least: no count can ask for more than there is.
        const std::size_t least = ListsMembers<T, ArchiveReader> ? 1 : sizeof(T);
        if (count > in_.size() / least) throw std::invalid_argument("the bytes end too early");
        list.clear();
        list.resize(std::size_t(count));
        if constexpr (ListsMembers<T, ArchiveReader>)
            for (T& element : list) (*this)(element);
        else
            raw(list.data(), list.size(), sizeof(T));
    }
    template <class... T>
    void operator()(std::tuple<T...>& tuple) {
        std::apply([this](T&... each) { ((*this)(each), ...); }, tuple);
    }
    template <class T, std::size_t n>
    void operator()(std::array<std::vector<T>, n>& lists) {
        for (auto& list : lists) (*this)(list);
    }
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
