// Reads recordings and replays them.

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <fettle/app/recording.h>
#include <fettle/property/exception_text.h>

#include <time/recording_text.h>

namespace fettle::app {

using property::Handle;
using property::Value;
using property::Writer;

namespace {

/// Bytes; an hour with the fastest possible events takes far less.
constexpr std::uintmax_t greatest_file = std::uintmax_t{4} << 30;

}  // namespace

/// A line after the line `begin`.
struct Recording::Item {
    enum class Kind : std::uint8_t {
        event,
        command,
        selected,
        write,
        reset,
        removed,
        edit,
        edit_ends,
        frame,
        turn,
        step
    };
    Kind kind = Kind::turn;
    InputEvent event{};
    bool taken = false;
    std::string text{};   // a command, a property, the name of an edit
    bool scripts = true;  // writes of scripts belong to the edit
    Writer writer = Writer::inspector;
    Handle instance{};
    std::vector<Handle> instances{};
    Value value{};
    double seconds = 0;
    std::int64_t limit = 0;
    std::uint64_t step = 0;
    Hashes hashes{};
    int line = 0;
};

Recording::~Recording() = default;

void Recording::fail(int number, const std::string& why) const {
    throw RecordingError(file_.string() + (number > 0 ? ":" + std::to_string(number) : "") + ": " +
                         why);
}

namespace {

/// A reference to an instance; nothing for another value.
std::optional<Handle> read_instance(Words& words) {
    const auto value = words.value();
    if (!value || !value->is(property::Type::reference)) return std::nullopt;
    return value->reference();
}

template <class Item>
bool read_selection(Words& words, Item& item) {
    do {
        const auto instance = read_instance(words);
        if (!instance) return false;
        item.instances.push_back(*instance);
    } while (!words.at_end());
    return true;
}

/// A write, a reset or the removal of a property.
template <class Item>
bool read_write(Words& words, Item& item) {
    const auto writer = words.integer();
    const auto instance = read_instance(words);
    const auto name = words.text();
    const auto value =
        item.kind == Item::Kind::write ? words.value() : std::optional<Value>(Value());
    if (!writer || *writer < 0 || *writer > static_cast<int>(Writer::restore) || !instance ||
        !name || !value)
        return false;
    item.writer = static_cast<Writer>(*writer);
    item.instance = *instance;
    item.text = *name;
    item.value = *value;
    return true;
}

template <class Item>
bool read_step(Words& words, Item& item) {
    const auto step = words.integer();
    if (!step || *step < 0) return false;
    item.step = static_cast<std::uint64_t>(*step);
    while (!words.at_end()) {
        const auto part = words.word();
        const auto hash = words.bits();
        if (!part || !hash) return false;
        item.hashes.emplace_back(*part, *hash);
    }
    return true;
}

/// Reads what follows the word of an item of this kind.
template <class Item>
bool read_rest(Words& words, Item& item) {
    using Kind = typename Item::Kind;
    switch (item.kind) {
        case Kind::event: {
            const auto event = parse_event(words);
            if (event) std::tie(item.event, item.taken) = *event;
            return event.has_value();
        }
        case Kind::command: {
            const auto text = words.text();
            if (text) item.text = *text;
            return text.has_value();
        }
        case Kind::selected:
            return read_selection(words, item);
        case Kind::write:
        case Kind::reset:
        case Kind::removed:
            return read_write(words, item);
        case Kind::edit: {
            const auto scripts = words.integer();
            const auto name = words.text();
            if (!scripts || !name) return false;
            item.scripts = *scripts != 0;
            item.text = *name;
            return true;
        }
        case Kind::frame: {
            const auto seconds = words.number();
            const auto limit = words.integer();
            if (!seconds || !limit) return false;
            item.seconds = *seconds;
            item.limit = *limit;
            return true;
        }
        case Kind::step:
            return read_step(words, item);
        case Kind::edit_ends:
        case Kind::turn:
            return true;
    }
    return false;
}

template <class Item>
std::optional<Item> parse(const std::string& word, Words& words) {
    using Kind = typename Item::Kind;
    static const std::map<std::string, Kind> kinds = {
        {"event", Kind::event},       {"command", Kind::command},
        {"selected", Kind::selected}, {"write", Kind::write},
        {"reset", Kind::reset},       {"removed", Kind::removed},
        {"edit", Kind::edit},         {"edit_ends", Kind::edit_ends},
        {"frame", Kind::frame},       {"turn", Kind::turn},
        {"step", Kind::step}};
    const auto kind = kinds.find(word);
    if (kind == kinds.end()) return std::nullopt;
    Item item;
    item.kind = kind->second;
    if (!read_rest(words, item) || !words.at_end()) return std::nullopt;
    return item;
}

}  // namespace

Recording::Recording(const std::filesystem::path& file) : file_(file) {
    std::error_code problem;
    const std::uintmax_t size = std::filesystem::file_size(file, problem);
    if (problem) fail(0, "cannot be read: " + problem.message());
    if (size > greatest_file) fail(0, "is too large for a recording");
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(0, "cannot be read");
    std::string line;
    bool begun = false;
    for (int number = 1; std::getline(in, line); ++number) {
        // The run was interrupted while the last line was written.
        if (in.eof() && number > 1) break;
        Words words(line);
        const std::string word = words.word().value_or("");
        if (number == 1) {
            const auto version = words.integer();
            if (word != "fettle-recording" || !version) fail(0, "is not a recording of Fettle");
            if (*version != recording_format)
                fail(0, "is a recording of format " + std::to_string(*version) +
                            ", and this Fettle reads " + std::to_string(recording_format));
        } else if (!begun) {
            begun = word == "begin";
            if (!begun) read_start(word, line.substr(std::min(word.size(), line.size())), number);
        } else if (word == "file" || word == "overwritten") {
            if (!read_file(word, line.substr(word.size())))
                fail(number, "is damaged: \"" + word + "\" has values that cannot be read");
        } else {
            auto item = parse<Item>(word, words);
            if (!item) fail(number, "is damaged: \"" + line.substr(0, 60) + "\" is unknown");
            item->line = number;
            items_.push_back(std::move(*item));
        }
    }
    if (!begun) fail(0, "is damaged: it ends before the run begins");
}

void Recording::read_start(const std::string& word, const std::string& rest, int number) {
    Words words(rest);
    const auto require = [&](bool holds) {
        if (!holds || !words.at_end())
            fail(number, "is damaged: \"" + word + "\" has values that cannot be read");
    };
    if (word == "game") {
        const auto path = words.text();
        require(path.has_value());
        start_.game = *path;
    } else if (word == "module") {
        const auto name = words.text();
        require(name.has_value());
        start_.modules.push_back(*name);
    } else if (word == "tweak") {
        std::vector<std::string>& tweak = start_.tweaks.emplace_back();
        while (auto text = words.text()) tweak.push_back(std::move(*text));
        require(!tweak.empty());
    } else if (word == "seed") {
        const auto seed = words.bits();
        require(seed.has_value());
        start_.seed = *seed;
    } else if (word == "screen") {
        const auto width = words.number(), height = words.number();
        require(width && height && *width >= 0 && *width < 1e6 && *height >= 0 && *height < 1e6);
        start_.width = *width;
        start_.height = *height;
    } else if (word == "eval") {
        const auto chunk = words.text();
        require(chunk.has_value());
        start_.evals.push_back(*chunk);
    } else if (word == "at") {
        const auto step = words.integer();
        const auto chunk = words.text();
        require(step && *step > 0 && chunk);
        start_.at.emplace_back(static_cast<std::uint64_t>(*step), *chunk);
    } else if (word == "test") {
        while (auto text = words.text()) start_.test.push_back(std::move(*text));
        require(start_.test.size() == 2);
    } else {
        fail(number, "is damaged: \"" + word + "\" is unknown");
    }
}

bool Recording::read_file(const std::string& word, const std::string& rest) {
    Words words(rest);
    const auto name = words.text();
    if (!name) return false;
    RunFile file{.name = *name, .overwritten = word == "overwritten"};
    if (!words.at_end()) {
        if (file.overwritten)
            file.content = words.text();
        else
            file.checksum = words.bits();
        if (!file.content && !file.checksum) return false;
    }
    files_.push_back(std::move(file));
    return words.at_end();
}

std::uint64_t Recording::steps() const {
    std::uint64_t count = 0;
    for (const Item& item : items_) count += item.kind == Item::Kind::step;
    return count;
}

// --- Replay

Replay::Replay(const Recording& recording, property::Tree& tree, script::Runtime& runtime,
               Loop& loop)
    : recording_(recording), tree_(tree), runtime_(runtime), loop_(loop) {
    loop_.set_observer(this);
}

Replay::~Replay() {
    loop_.set_observer(nullptr);
}

bool Replay::frame() {
    using Kind = Recording::Item::Kind;
    const auto& items = recording_.items_;
    while (next_ < items.size() && difference_.empty()) {
        const Recording::Item& item = items[next_++];
        if (item.kind != Kind::frame && item.kind != Kind::turn) {
            feed(item);
            continue;
        }
        if (item.kind == Kind::frame)
            loop_.frame(item.seconds, item.limit);
        else
            loop_.turn();
        if (difference_.empty() && next_ < items.size() && items[next_].kind == Kind::step)
            difference_ = "step " + std::to_string(items[next_].step) +
                          " was recorded, but the replay does not make it";
        return difference_.empty();
    }
    return false;
}

void Replay::feed(const Recording::Item& item) {
    using Kind = Recording::Item::Kind;
    switch (item.kind) {
        case Kind::event:
            return loop_.feed(item.event, item.taken);
        case Kind::command:
            (void)runtime_.evaluate(item.text);
            return;
        case Kind::selected:
            if (select_)
                select_(item.instances);
            else
                runtime_.set_selected(item.instances.back());
            return;
        case Kind::edit:
            return tree_.begin_edit(item.text, item.scripts);
        case Kind::edit_ends:
            return tree_.end_edit();
        case Kind::step:
            difference_ = "step " + std::to_string(item.step) +
                          " was recorded, but the replay does not make it";
            return;
        default:
            break;
    }
    const property::Tree::CauseScope cause(tree_, item.writer);
    try {
        const property::Property& property = tree_.property(item.instance, item.text);
        if (item.kind == Kind::write)
            tree_.set(item.instance, property, item.value);
        else if (item.kind == Kind::removed)
            tree_.remove_ad_hoc(item.instance, item.text);
        else
            tree_.reset(item.instance, property);
    } catch (const std::exception& error) {
        difference_ = "an edit recorded after step " + std::to_string(tree_.step()) +
                      " is refused in the replay: " + property::exception_text(error);
    }
}

void Replay::compare(const Hashes& then, const std::string& step) {
    const Hashes hashes = loop_.hashes();
    for (const auto& [part, hash] : then) {
        const auto found =
            std::find_if(hashes.begin(), hashes.end(),
                         [&, name = part](const auto& h) { return h.first == name; });
        if (found == hashes.end())
            difference_ = step + ": there is no \"" + part + "\" in this game";
        else if (found->second != hash)
            difference_ = step + ": " + part + " differs: " + hex(hash) + " then, " +
                          hex(found->second) + " now";
        if (!difference_.empty()) return;
    }
}

void Replay::stepped() {
    if (!difference_.empty()) return;
    const std::string now = "step " + std::to_string(tree_.step());
    const auto& items = recording_.items_;
    if (next_ >= items.size()) return;  // the recording ends in the middle of a frame
    const Recording::Item& item = items[next_];
    if (item.kind != Recording::Item::Kind::step || item.step != tree_.step()) {
        difference_ = now + " was not recorded, but the replay makes it";
        return;
    }
    ++next_;
    if (!item.hashes.empty()) compare(item.hashes, now);
    if (difference_.empty()) ++steps_;
}

}  // namespace fettle::app
