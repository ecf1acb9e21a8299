#pragma once
// The text of a store: JSON. A table with names is an object, one with the keys 1, 2, 3 ... an
// array. A value that JSON does not have is an object with one key that begins with $: {"$vec2":
// [1, 2]}.

#include <string>

#include <fettle/property/storage/store.h>

namespace fettle::property {

/// The text with all entries of the table.
std::string store_text(const Store::Content& content);

/// The content in a text. Throws Error(damaged) with the reason if it is not a text of a store.
Store::Content store_content(const std::string& text);

/// About how many bytes the entry takes, with everything in it.
std::size_t store_size(const Store::Key& key, const Store::Entry& entry);

/// A copy whose tables are not shared with the original.
Store::Entry store_copy(const Store::Entry& entry);

}  // namespace fettle::property
