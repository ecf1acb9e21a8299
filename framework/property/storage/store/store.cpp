#include <fettle/property/storage/store.h>

#include <chrono>
#include <system_error>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>
#include <fettle/property/storage/scene.h>

#include <files/durable_file.h>
#include <files/file_access.h>
#include <json/document.h>
#include <store/store_text.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

// Bytes of the file. A control character is written as six characters, and a vector in six lines
// that begin with a tab for each table around it.
constexpr std::size_t largest_store = 16 * Store::size_limit;
constexpr std::chrono::milliseconds store_delay{500};

bool is_utf8(const std::string& text) {
    std::string quoted;
    return append_quoted(quoted, text);
}

/// Gives a damaged file another name, so that nothing of it is lost.
void move_aside(const fs::path& file) {
    std::error_code error;
    for (int i = 1; i < 1000; ++i) {
        fs::path other = file;
        other.replace_extension(".damaged-" + std::to_string(i) + ".json");
        if (fs::exists(other, error)) continue;
        fs::rename(file, other, error);
        if (error) throw FileError(file, "is damaged, and cannot be renamed: " + error.message());
        return;
    }
    throw FileError(file, "is damaged, and there are too many damaged ones beside it");
}

}  // namespace

/// Changes of the root since the last write.
struct Store::Changes {
    bool cleared = false;
    std::map<Key, Entry> entries;  // nil: removed

    /// Applies them to the file as it is now. Another process may have written other keys since.
    void write(const fs::path& file) const {
        std::error_code error;
        const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
        fs::create_directories(folder, error);
        if (error) throw FileError(folder, "cannot be made: " + error.message());
        const Descriptor locked = lock_folder(folder);
        Content content;
        if (fs::exists(file, error)) try {
                content = store_content(read_file(file, largest_store));
            } catch (const FileError&) {
                throw;
            } catch (const Error&) {
                move_aside(file);
            }
        if (cleared) content.entries.clear();
        for (const auto& [key, entry] : entries) {
            if (entry.content || !entry.value.is_nil())
                content.entries[key] = entry;
            else
                content.entries.erase(key);
        }
        const std::string text = store_text(content);
        // A store that cannot be read must not replace one that can.
        if (text.size() > largest_store)
            throw FileError(file,
                            "would be larger than " + std::to_string(largest_store >> 20) + " MiB");
        replace_file(file, text);
    }
};

Store::Store(fs::path file, Options options)
    : file_(std::move(file)), options_(std::move(options)) {
    Entry whole{.content = std::make_shared<Content>()};
    std::error_code error;
    try {
        if (options_.content)
            initial_ = *options_.content;
        else if (!file_.empty() && fs::exists(file_, error))
            initial_ = read_file(file_, largest_store);
        if (!initial_.empty()) *whole.content = store_content(initial_);
    } catch (const Error& problem) {
        initial_.clear();
        std::string text = problem.what();
        if (dynamic_cast<const FileError*>(&problem) == nullptr)
            text = file_.string() + ": " + text +
                   "; when the game writes its store, this file gets another name";
        if (options_.warn) options_.warn(options_.name + " is empty: " + text);
    }
    tables_[root] = {.content = whole.content, .key = {}, .top = {}};
    for (auto& [key, entry] : whole.content->entries) {
        bytes_ += store_size(key, entry);
        adopt(entry, root, key);
    }
}

Store::~Store() {
    try {
        flush();
    } catch (...) {  // the warning of a host failed; the file is as it was
    }
}

const Store::Place& Store::place(Table table) const {
    const auto found = tables_.find(table);
    if (found == tables_.end())
        throw Error(ErrorKind::deleted,
                    "this table is no longer in the store: it was replaced or removed");
    return found->second;
}

const std::map<Store::Key, Store::Entry>& Store::entries(Table table) const {
    return place(table).content->entries;
}

const Store::Entry* Store::find(Table table, const Key& key) const {
    const auto& all = entries(table);
    const auto found = all.find(key);
    return found == all.end() ? nullptr : &found->second;
}

std::string Store::path(Table table, const Key& key) const {
    const auto found = tables_.find(table);
    const std::string above = table == root || found == tables_.end()
                                  ? "store"
                                  : path(found->second.parent, found->second.key);
    if (const auto* const number = std::get_if<std::int64_t>(&key))
        return above + "[" + std::to_string(*number) + "]";
    return above + path_suffix(std::get<std::string>(key));
}

namespace {

/// Throws for an entry that a store cannot hold; `depth`: of the table around it.
void check_entry(const Store::Key& key, const Store::Entry& entry, int depth,
                 const std::string& path) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::wrong_type, path + ": " + why);
    };
    if (const auto* const name = std::get_if<std::string>(&key); name != nullptr && !is_utf8(*name))
        refuse("a key in the store is a text in UTF-8");
    if (entry.content) {
        if (depth + 1 > Store::depth_limit)
            refuse("tables in the store are nested at most " + std::to_string(Store::depth_limit) +
                   " deep");
        for (const auto& [inner, each] : entry.content->entries)
            check_entry(inner, each, depth + 1, path);
        return;
    }
    if (entry.value.is(Type::reference))
        refuse("an instance cannot be in the store, because it ends with the run");
    if (entry.value.is(Type::list)) refuse("a list is put into the store as a table");
    if (entry.value.is(Type::text) && !is_utf8(entry.value.text()))
        refuse("a text in the store is UTF-8");
}

}  // namespace

std::size_t Store::size_of(const Key& key, const Value& value) {
    std::size_t size = 32;
    if (const auto* const name = std::get_if<std::string>(&key)) size += name->size();
    if (value.is(Type::text)) size += value.text().size();
    if (value.is(Type::vec2)) size += 32;
    if (value.is(Type::color)) size += 96;
    return size;
}

void Store::refuse_size(const std::string& path) {
    throw Error(ErrorKind::rejected, path + ": the store would have more than " +
                                         std::to_string(size_limit >> 20) + " MiB");
}

void Store::set(Table table, const Key& key, Entry entry) {
    const Place& in = place(table);
    const bool removes = !entry.content && entry.value.is_nil();
    check_entry(key, entry, in.depth, path(table, key));
    const auto found = in.content->entries.find(key);
    const bool there = found != in.content->entries.end();
    if (removes && !there) return;
    // The most frequent write changes nothing.
    if (there && !found->second.content && !entry.content && found->second.value == entry.value)
        return;
    const std::size_t before = there ? store_size(key, found->second) : 0;
    const std::size_t after = removes ? 0 : store_size(key, entry);
    if (after > before && bytes_ - before + after > size_limit) refuse_size(path(table, key));
    entry.table = 0;
    const Key top = table == root ? key : in.top;
    if (there) drop(found->second);
    bytes_ = bytes_ - before + after;
    if (removes) {
        in.content->entries.erase(found);
    } else {
        Entry& put = in.content->entries[key];
        put = std::move(entry);
        adopt(put, table, key);
    }
    note(top);
}

/// Gives the tables of a new entry their places.
void Store::adopt(Entry& entry, Table parent, const Key& key) {
    if (!entry.content) return;
    entry.table = next_++;
    const Place& above = place(parent);
    tables_[entry.table] = {.content = entry.content,
                            .parent = parent,
                            .key = key,
                            .top = parent == root ? key : above.top,
                            .depth = above.depth + 1};
    for (auto& [inner, each] : entry.content->entries) adopt(each, entry.table, inner);
}

void Store::drop(const Entry& entry) {
    if (!entry.content) return;
    tables_.erase(entry.table);
    for (const auto& [key, each] : entry.content->entries) drop(each);
    if (entry.content.use_count() > 1) track_removed_content(entry);
}

/// Limits the memory of contents that are no longer in the store and that readers still have.
void Store::track_removed_content(const Entry& entry) {
    const std::size_t bytes = store_size({}, entry);
    gone_.push_back({entry.content, bytes});
    gone_bytes_ += bytes;
    if (gone_bytes_ <= size_limit) return;
    gone_bytes_ = 0;
    std::erase_if(gone_, [](const Gone& each) { return each.content.expired(); });
    // Keeps the latest contents, up to half of the limit, so that this loop runs rarely.
    auto kept = gone_.end();
    while (kept != gone_.begin() && gone_bytes_ + (kept - 1)->bytes <= size_limit / 2)
        gone_bytes_ += (--kept)->bytes;
    for (auto each = gone_.begin(); each != kept; ++each)
        if (const auto content = each->content.lock()) *content = {.forgotten = true};
    gone_.erase(gone_.begin(), kept);
}

void Store::clear() {
    auto& all = tables_[root].content->entries;
    for (const auto& [key, entry] : all) drop(entry);
    all.clear();
    bytes_ = 0;
    changed_.clear();
    if (!cleared_) since_ = std::chrono::steady_clock::now();
    cleared_ = true;
}

void Store::note(const Key& top) {
    if (file_.empty() && options_.writes && problem_.empty()) {
        problem_ = "there is no folder for it";
        if (options_.warn) options_.warn(options_.name + " ends with the run: " + problem_);
    }
    if (changed_.empty() && !cleared_) since_ = std::chrono::steady_clock::now();
    changed_[top] = true;
}

// --- Writing

Store::Changes Store::take_changes() {
    Changes changes;
    changes.cleared = std::exchange(cleared_, false);
    for (const auto& [key, changed] : std::exchange(changed_, {})) {
        const Entry* const entry = find(root, key);
        changes.entries[key] = entry == nullptr ? Entry{} : store_copy(*entry);
    }
    return changes;
}

/// The changes could not be written, so they are to be written again.
void Store::put_back(Changes changes) {
    // Entries that a later clear() has removed are not written again.
    if (!cleared_)
        for (const auto& [key, entry] : changes.entries) changed_[key] = true;
    cleared_ = cleared_ || changes.cleared;
    since_ = std::chrono::steady_clock::now();
}

void Store::finish() {
    if (!writing_.valid()) return;
    const std::string problem = writing_.get();
    if (!problem.empty()) put_back(std::move(*in_work_));
    in_work_.reset();
    if (!problem.empty() && std::exchange(problem_, problem) != problem && options_.warn)
        options_.warn(options_.name + " was not written: " + problem);
}

void Store::tick() {
    if (!options_.writes || file_.empty()) return;
    const auto now = std::chrono::steady_clock::now();
    if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        finish();
    if (writing_.valid() || (changed_.empty() && !cleared_) || now - since_ < store_delay) return;
    in_work_ = std::make_unique<Changes>(take_changes());
    // Waiting for the disk would be seen as a pause of the game.
    writing_ = std::async(std::launch::async, [changes = in_work_.get(), file = file_] {
        try {
            changes->write(file);
            return std::string();
        } catch (const std::exception& error) {
            return exception_text(error);
        }
    });
}

void Store::flush() {
    if (!options_.writes || file_.empty()) return;
    finish();
    if (changed_.empty() && !cleared_) return;
    Changes changes = take_changes();
    try {
        changes.write(file_);
    } catch (const std::exception& error) {
        put_back(std::move(changes));
        if (options_.warn)
            options_.warn(options_.name + " was not written: " + exception_text(error));
    }
}

}  // namespace fettle::property
