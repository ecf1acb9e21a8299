#pragma once
// The store of a game: values that outlive a run, such as high scores and settings. Tables of
// values by name or number, nested, in a file that is replaced as a whole. It is not part of the
// tree: snapshots, rewinding and saved games leave it as it is.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include <fettle/property/storage/export.h>
#include <fettle/property/value.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

class Store {
  public:
    /// Numbers come before names.
    using Key = std::variant<std::int64_t, std::string>;
    /// Identifies a table while it is in the store. Numbers are not used again.
    using Table = std::uint64_t;
    static constexpr Table root = 1;
    struct Content;
    /// A value (nil, boolean, integer, number, text, vec2 or color), or the content of a table.
    struct Entry {
        Value value{};
        std::shared_ptr<Content> content{};  // null: a value
        Table table = 0;                     // of an entry that is in the store
    };
    struct Content {
        std::map<Key, Entry> entries{};
        bool forgotten = false;  // it was replaced or removed, and its entries are not kept
    };

    static constexpr std::size_t size_limit = std::size_t{16} << 20;  // bytes, estimated
    static constexpr int depth_limit = 100;                           // nested tables
    /// The estimated bytes of an entry without those below it.
    static std::size_t size_of(const Key& key, const Value& value);
    /// Refuses more than `size_limit` bytes at `path`.
    [[noreturn]] static void refuse_size(const std::string& path);

    struct Options {
        /// In place of the file, for a replay: the text that the file had.
        std::optional<std::string> content{};
        /// False: nothing is written.
        bool writes = true;
        /// Receives errors of the file. They do not end the run.
        std::function<void(const std::string&)> warn{};
        /// The name of the store in these errors.
        std::string name = "the store of the game";
    };
    /// Reads the file, which may be missing. A damaged file is reported to `warn`, and is moved
    /// aside before the first write.
    Store(std::filesystem::path file, Options options);
    /// Writes all entries that are not written yet.
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// The text of the file when it was read; empty if there was none.
    const std::string& initial() const { return initial_; }
    const std::filesystem::path& file() const { return file_; }

    /// False for a table that was replaced or removed.
    bool has(Table table) const { return tables_.contains(table); }
    /// The content of a table. Throws Error(deleted) unless `has(table)`. The result keeps its
    /// entries after the table is replaced or removed. If such contents together take more than
    /// `size_limit` bytes, the oldest lose their entries (`Content::forgotten`).
    std::shared_ptr<const Content> content(Table table) const { return place(table).content; }
    /// The entries of a table. Throws Error(deleted) unless `has(table)`.
    const std::map<Key, Entry>& entries(Table table) const;
    /// nullptr if there is no such entry.
    const Entry* find(Table table, const Key& key) const;
    /// A path for messages: "store.levels[3]".
    std::string path(Table table, const Key& key) const;
    /// Puts an entry, a nil removes it. The entry's content is taken over. Throws Error: for texts
    /// that are not UTF-8, references and lists, tables nested too deep, more than `size_limit`
    /// bytes, a deleted table; then nothing has changed.
    void set(Table table, const Key& key, Entry entry);
    /// Removes everything.
    void clear();

    /// Call often: writes changes that are half a second old, in the background.
    void tick();
    /// Writes all changes now.
    void flush();

  private:
    struct Place {
        std::shared_ptr<Content> content;
        Table parent = 0;
        Key key;        // in the parent
        Key top;        // key in the root of the branch with this table
        int depth = 0;  // 0: the root
    };
    struct FETTLE_STORAGE_PRIVATE Changes;
    const Place& place(Table table) const;
    void adopt(Entry& entry, Table parent, const Key& key);
    void drop(const Entry& entry);
    void track_removed_content(const Entry& entry);
    void note(const Key& top);
    Changes take_changes();
    void put_back(Changes changes);
    void finish();

    std::filesystem::path file_;
    Options options_;
    std::string initial_;
    std::unordered_map<Table, Place> tables_;
    Table next_ = root + 1;
    std::size_t bytes_ = 0;
    // The content of a table that was replaced or removed while a reader still had it.
    struct Gone {
        std::weak_ptr<Content> content;
        std::size_t bytes = 0;
    };
    std::vector<Gone> gone_;
    std::size_t gone_bytes_ = 0;
    // Not written yet: everything was removed, and then these keys of the root have changed.
    bool cleared_ = false;
    std::map<Key, bool> changed_;
    std::chrono::steady_clock::time_point since_{};  // of the first change
    std::future<std::string> writing_;               // its result is the error
    std::unique_ptr<Changes> in_work_;
    std::string problem_;  // the last one that was reported
};

}  // namespace fettle::property

FETTLE_STORAGE_END
