#pragma once
// Symbols: names converted once to small numbers, so that comparing two names is comparing two
// integers.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// An interned name. Interning is thread-safe; symbols live as long as the process.
class Symbol {
  public:
    /// The greatest number of different names in a process; a name is never released.
    static constexpr std::uint32_t max_count = std::uint32_t{1} << 22;

    Symbol() = default;
    /// Throws Error(bad_name) if there are too many different names.
    explicit Symbol(std::string_view text);
    /// The symbol of `text` if it exists, otherwise the empty symbol. Never adds a symbol, so that
    /// names typed by a user or read from a file use no memory.
    static Symbol find(std::string_view text);
    const std::string& text() const;                     ///< "" for the empty symbol
    std::uint32_t id() const { return id_; }             ///< 0 for the empty symbol
    explicit operator bool() const { return id_ != 0; }  ///< false: empty
    friend bool operator==(Symbol, Symbol) = default;

  private:
    std::uint32_t id_ = 0;
};

}  // namespace fettle::property

template <>
struct std::hash<fettle::property::Symbol> {
    std::size_t operator()(fettle::property::Symbol s) const noexcept {
        return s.id() * 0x9e3779b1u;
    }
};

FETTLE_PROPERTY_END
