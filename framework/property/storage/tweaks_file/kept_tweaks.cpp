// The file of kept tweaks: reading, editing and writing it.

#include <tweaks_file/kept_tweaks.h>

#include <algorithm>
#include <array>
#include <utility>

#include <fettle/property/coercion.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>

#include <json/unknown_keys.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

constexpr std::string_view version_of_tweaks = "fettle_tweaks";
constexpr int format_version = 1;
constexpr std::string_view empty_file = "{\n  \"fettle_tweaks\": 1\n}\n";

bool all_names(const std::vector<Segment>& segments) {
    return std::none_of(segments.begin(), segments.end(),
                        [](const Segment& each) { return each.is_index(); });
}

}  // namespace

KeptTweaks::KeptTweaks(Tree& tree, GameFiles& files, std::filesystem::path file, Warn warn)
    : tree_(tree),
      files_(files),
      file_(std::move(file)),
      warn_(std::move(warn)),
      tree_life_(tree.lifetime()) {
    reload();
    if (!problem_.empty()) warn_(problem_ + "; the tweaks kept in this file are not applied");
    // `compare_with_given` names the places in scripts.
    if (document_ != nullptr && document_->member(document_->root(), "given") != nullptr)
        located_ = std::make_unique<LocatedWrites>(tree_);
}

KeptTweaks::~KeptTweaks() {
    if (tree_life_.expired()) (void)located_.release();  // it would change the tree
}

void KeptTweaks::reload() {
    changes_.clear();
    unwritten_ = false;
    document_.reset();
    set_contents({});
    problem_.clear();
    if (!files_.exists(file_)) return;
    try {
        read();
    } catch (const Error& error) {
        problem_ = error.what();
        set_contents({});
    }
}

void KeptTweaks::read() {
    document_ = std::make_shared<const Document>(files_.read(file_), file_.string());
    const Node& root = document_->root();
    const Node* version = document_->member(root, version_of_tweaks);
    if (version != nullptr && version->kind != Document::Kind::integer)
        document_->fail(ErrorKind::bad_structure, version->begin,
                        "no file of tweaks: \"fettle_tweaks\": expected the version of the format, "
                        "which is a whole number, found " +
                            std::string(kind_words(version->kind)));
    if (version == nullptr || version->kind != Document::Kind::integer || version->integer < 1)
        document_->fail(ErrorKind::bad_structure, root.begin,
                        "no file of tweaks: the key \"fettle_tweaks\" with the version of the "
                        "format is missing");
    if (version->integer > format_version)
        document_->fail(ErrorKind::bad_structure, version->begin,
                        "was written by a newer Fettle (version " +
                            std::to_string(version->integer) + " of the format)");
    static const std::vector<std::string> known = {
        std::string(version_of_tweaks), "values", "given", "created", "moved", "deleted"};
    for (const Node* node = document_->first(root); node; node = document_->next(*node))
        if (const std::string& key = document_->key(*node);
            std::find(known.begin(), known.end(), key) == known.end())
            warn(node->key_begin, "a file of kept tweaks has no key " + value_text(Value(key)) +
                                      suggestion(key, known) + "; what it holds has no effect");
    set_contents(contents_of(*document_));
}

void KeptTweaks::set_contents(Contents contents) {
    contents_ = std::move(contents);
    created_ = {contents_.created.begin(), contents_.created.end()};
}

KeptTweaks::Contents KeptTweaks::contents_of(const Document& document) {
    Contents contents;
    const auto section = [&](const char* name, Document::Kind kind) {
        const Node* node = document.member(document.root(), name);
        if (node != nullptr && node->kind != kind)
            document.fail(ErrorKind::bad_structure, node->begin,
                          "expected " + std::string(kind_words(kind)));
        return node;
    };
    const auto names = [&](const std::string& path, std::size_t offset) {
        try {
            std::vector<Segment> segments = parse_path(path);
            if (!segments.empty() && all_names(segments)) return segments;
        } catch (const Error&) {
        }
        document.fail(ErrorKind::bad_path, offset, "\"" + path + "\" is not a path of names");
    };
    if (const Node* values = section("values", Document::Kind::object))
        for (const Node* node = document.first(*values); node; node = document.next(*node)) {
            const std::string& key = document.key(*node);
            const std::vector<Segment> path = names(key, node->key_begin);
            const std::string instance =
                path.size() == 1 ? "game" : joined_path(path, path.size() - 1);
            contents.values[instance].push_back({std::get<std::string>(path.back().key), key});
        }
    (void)section("given", Document::Kind::object);
    if (const Node* created = section("created", Document::Kind::object))
        for (const Node* node = document.first(*created); node; node = document.next(*node)) {
            const std::string& key = document.key(*node);
            (void)names(key, node->key_begin);
            contents.created.push_back(key);
        }
    const auto path_in = [&](const Node& node) {
        if (node.kind != Document::Kind::text)
            document.fail(ErrorKind::bad_structure, node.begin, "expected a path");
        const std::vector<Segment> path = names(document.text(node), node.begin);
        return joined_path(path, path.size());
    };
    if (const Node* moved = section("moved", Document::Kind::object))
        for (const Node* node = document.first(*moved); node; node = document.next(*node)) {
            const std::string& key = document.key(*node);
            const std::vector<Segment> path = names(key, node->key_begin);
            const std::string home = joined_path(path, path.size()), now = path_in(*node);
            if (home == now) continue;
            if (!contents.moves.moved_from(home).empty() || contents.moves.moves_to(now))
                document.fail(ErrorKind::bad_structure, node->begin,
                              "another line moves " + home + ", or something to " + now);
            contents.moved.push_back({key, home, now});
            contents.moves.add(home, now);
        }
    if (const Node* deleted = section("deleted", Document::Kind::array))
        for (const Node* node = document.first(*deleted); node; node = document.next(*node))
            contents.deleted.push_back(path_in(*node));
    return contents;
}

// --- Writing -------------------------------------------------------------------------------------

void KeptTweaks::put(const std::string& section, const std::string& key, const std::string& value) {
    if (!problem_.empty())
        throw Error(ErrorKind::rejected, problem_ + "; mend or remove that file first");
    change(section, key, value);
}

void KeptTweaks::put_deleted(const std::string& path) {
    std::string quoted;
    append_quoted(quoted, path);
    put("deleted", path, quoted);
}

std::string KeptTweaks::text_of(const std::string& section, const std::string& key) const {
    const Node& node = *member(section, key);
    return without_indent(std::string(document_->raw(node)), *document_, node);
}

void KeptTweaks::drop(const std::string& section, const std::string& key) {
    change(section, key, std::nullopt);
    if (section == "values") change("given", key, std::nullopt);
}

void KeptTweaks::change(const std::string& section, const std::string& key,
                        std::optional<std::string> value) {
    auto its = std::find_if(changes_.begin(), changes_.end(),
                            [&](const Changes& each) { return each.section == section; });
    if (its == changes_.end()) its = changes_.insert(its, Changes{section});
    const auto [place, first] = its->places.try_emplace(key, its->list.size());
    if (first)
        its->list.push_back({key, std::move(value)});
    else
        its->list[place->second].value = std::move(value);
}

/// Writes the changes into the text. Existing entries stay in their places and get the new value;
/// new entries are added at the end.
void KeptTweaks::apply(JsonEdit& edit, const Changes& changes) {
    const auto section = [&](const Document& in) { return in.member(in.root(), changes.section); };
    const auto key_of = [](const Document& in, const Node& node) -> std::string {
        if (in.has_key(node)) return in.key(node);
        return node.kind == Document::Kind::text ? in.text(node) : std::string();
    };
    const auto change_of = [&](const Document& in, const Node& node) -> const Change* {
        const auto found = changes.places.find(key_of(in, node));
        return found == changes.places.end() ? nullptr : &changes.list[found->second];
    };
    const bool keyed = changes.section != "deleted";
    std::unordered_set<std::string> there;
    std::vector<std::pair<const Node*, std::string>> replaced;
    std::size_t remaining_count = 0, removed_count = 0;
    if (const Node* object = section(edit.document()))
        for (const Node* node = edit.document().first(*object); node;
             node = edit.document().next(*node)) {
            const Change* change = change_of(edit.document(), *node);
            const bool goes = change != nullptr && !change->value;
            ++(goes ? removed_count : remaining_count);
            if (change == nullptr || goes) continue;
            there.insert(change->key);
            if (keyed) replaced.emplace_back(node, *change->value);
        }
    edit.replace(replaced);
    std::vector<std::pair<std::string, std::string>> added;
    for (const Change& each : changes.list)
        if (each.value && !there.contains(each.key)) added.emplace_back(each.key, *each.value);
    if (!added.empty()) {
        if (section(edit.document()) == nullptr)
            edit.add_member(edit.document().root(), changes.section, keyed ? "{}" : "[]");
        edit.add_last(section, added);
    }
    if (removed_count == 0) return;
    if (remaining_count == 0 && added.empty())
        return edit.remove(edit.document().root(), *section(edit.document()));
    edit.remove(section, [&](const Document& in, const Node& node) {
        const Change* change = change_of(in, node);
        return change != nullptr && !change->value;
    });
}

void KeptTweaks::set(const std::string& instance, const std::string& property,
                     const Property* declared, const Image& image, const NewPath& written) {
    const std::string path = path_below(instance, property);
    if (image.kind == Image::Kind::absent) {
        drop("values", path);
        return put("values", path, "null");
    }
    if (image.kind == Image::Kind::by_default) return put("values", path, "null");
    check_value(path, declared, image);
    put("values", path, image_in_file(tree_, declared, image, written));
    // The person knows the value that the script gives now, and wants another one again.
    const auto now = given_now_.find(path);
    if (now != given_now_.end() && member("given", path) != nullptr)
        put("given", path, now->second.value);
}

void KeptTweaks::note_given(const std::string& instance, const std::string& property,
                            const Property* declared, const Image& image, const NewPath& written) {
    const std::string path = path_below(instance, property);
    if (document_ != nullptr && member("values", path) != nullptr) return;
    put("given", path, image_in_file(tree_, declared, image, written));
}

/// The value may come from a run with other classes, or be invalid.
void KeptTweaks::check_value(const std::string& path, const Property* declared,
                             const Image& image) const {
    const Value value = image_value(tree_, image);
    if (declared != nullptr) {
        require_settable_in_scene(*declared);
        if (declared->read_only) throw Error(ErrorKind::read_only, path + ": it is read-only");
        (void)coerced(tree_, *declared, value, path);
    }
    if (image.kind == Image::Kind::formula && image.not_saved.empty())
        (void)make_formula(tree_, image.source, value);
}

void KeptTweaks::add(const std::string& path, const std::string& scene) {
    // A deletion of the same path stays in the file: what the script makes there is still deleted.
    std::string text = scene;
    while (text.ends_with('\n')) text.pop_back();
    put("created", path, text);
}

void KeptTweaks::forget_value(const std::string& instance, const std::string& property) {
    if (const auto its = contents_.values.find(instance); its != contents_.values.end())
        for (const Kept& kept : its->second)
            if (kept.property == property) drop("values", kept.key);
}

/// Applies the changes so far to the document in memory. Throws SceneError if the result would be
/// unreadable.
void KeptTweaks::fold() {
    if (changes_.empty()) return;
    std::vector<Changes> changes = std::exchange(changes_, {});
    // The order of sections in the file must not depend on the order of changes.
    static constexpr std::array<std::string_view, 5> sections{"values", "given", "created", "moved",
                                                              "deleted"};
    const auto place = [](const Changes& each) {
        return std::find(sections.begin(), sections.end(), each.section);
    };
    std::sort(changes.begin(), changes.end(),
              [&](const Changes& a, const Changes& b) { return place(a) < place(b); });
    const std::string before = document_ ? document_->source() : std::string(empty_file);
    JsonEdit edit(before, file_.string());
    for (const Changes& each : changes) apply(edit, each);
    if (edit.text() == before) return;
    auto document = std::make_shared<const Document>(edit.text(), file_.string());
    set_contents(contents_of(*document));
    document_ = std::move(document);
    unwritten_ = true;
}

void KeptTweaks::write() {
    fold();
    if (!unwritten_) return;
    files_.write(file_, document_->source());
    unwritten_ = false;
}

}  // namespace fettle::property
