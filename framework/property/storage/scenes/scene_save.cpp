// Writes instances of the tree as a scene file.

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>

#include <files/durable_file.h>
#include <json/document.h>
#include <json/unknown_keys.h>
#include <scenes/scene_text.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

constexpr std::size_t deepest_instance = 400;

/// The members of one JSON object, one per line.
class Members {
  public:
    Members(std::string& out, std::size_t indent) : out_(out), indent_(indent) { out_ += '{'; }
    Members(const Members&) = delete;
    Members& operator=(const Members&) = delete;

    /// Starts the next member and returns the column where its value begins. Returns npos for a key
    /// that is not UTF-8.
    std::size_t key(std::string_view key) {
        out_ += empty_ ? "\n" : ",\n";
        empty_ = false;
        const std::size_t line = out_.size();
        out_.append(indent_ + 2, ' ');
        if (!append_quoted(out_, key)) return std::string::npos;
        out_ += ": ";
        return out_.size() - line;
    }
    void raw(std::string_view name, std::string_view value) {
        key(name);
        out_ += value;
    }
    void close() {
        if (!empty_) {
            out_ += '\n';
            out_.append(indent_, ' ');
        }
        out_ += '}';
    }
    bool empty() const { return empty_; }

  private:
    std::string& out_;
    std::size_t indent_;
    bool empty_ = true;
};

class SceneWriter {
  public:
    /// `references_from`: paths of references inside it begin there; null: all paths begin at the
    /// root.
    SceneWriter(const Tree& tree, Handle top, Handle references_from,
                std::vector<std::string>* warnings, std::function<bool(Handle)> left_out = {},
                SceneValues* noted = nullptr, const SceneValues* given = nullptr)
        : tree_(tree),
          top_(top),
          warnings_(warnings),
          values_(tree, references_from),
          left_out_(std::move(left_out)),
          noted_(noted),
          given_(given) {}

    std::string run() {
        tree_.require(top_);
        if (top_ == tree_.root()) {
            throw Error(ErrorKind::bad_structure,
                        "game, the root of the tree, is not a scene: save what is below it");
        }
        if (!tree_.class_of(top_).creatable()) {
            throw Error(ErrorKind::bad_structure,
                        tree_.path(top_) + " is " + with_article(tree_.class_of(top_).name()) +
                            ", which loading a scene could not create again");
        }
        instance(top_, 0, 1);
        out_ += '\n';
        return std::move(out_);
    }

  private:
    void instance(Handle handle, std::size_t indent, std::size_t depth) {
        if (depth > deepest_instance) {
            throw Error(ErrorKind::bad_structure,
                        tree_.path(handle) + ": a scene file holds at most " +
                            std::to_string(deepest_instance) + " instances inside each other");
        }
        if (noted_ != nullptr) noted_->add(handle);
        Members members(out_, indent);
        if (handle == top_) members.raw(version_key, std::to_string(scene_format_version));
        members.key("class");
        append_quoted(out_, tree_.class_of(handle).name());
        members.key("name");
        if (!append_quoted(out_, tree_.name(handle))) {
            throw Error(ErrorKind::bad_name,
                        tree_.path(handle) + ": a file cannot hold a name that is not UTF-8");
        }
        const std::optional<Document> unknown = unknown_keys(tree_, handle);
        const Document* kept = unknown ? &*unknown : nullptr;
        declared(handle, members, indent + 2, kept);
        ad_hoc(handle, members, indent + 2, kept);
        if (kept != nullptr) other_keys(handle, members, *kept);
        children(handle, members, indent + 2, depth);
        members.close();
    }

    void declared(Handle handle, Members& members, std::size_t indent, const Document* kept) {
        std::vector<const Property*> written;
        for (const Property* property : tree_.class_of(handle).properties()) {
            if (property->read_only || property->transient) continue;
            if (given_ != nullptr ? given_->value(handle, property->name) != nullptr
                                  : tree_.overridden(handle, *property) ||
                                        tree_.formula(handle, *property) != nullptr)
                if (has_text(handle, *property)) written.push_back(property);
        }
        const auto unknown = kept_in(kept, "properties", [&](const std::string& name) {
            return tree_.class_of(handle).property(name) == nullptr;
        });
        object("properties", handle, members, indent, written, kept, unknown);
    }

    void ad_hoc(Handle handle, Members& members, std::size_t indent, const Document* kept) {
        std::vector<const Property*> written;
        for (const Property* property : tree_.ad_hoc(handle)) {
            if (property->transient) continue;
            if (given_ != nullptr && given_->value(handle, property->name) == nullptr) continue;
            if (kept != nullptr && property->name == unknown_keys_property) continue;
            written.push_back(property);
        }
        const auto unknown = kept_in(kept, "ad_hoc", [&](const std::string& name) {
            return tree_.find(handle, name) == nullptr;
        });
        object("ad_hoc", handle, members, indent, written, kept, unknown);
    }

    void object(std::string_view key, Handle handle, Members& members, std::size_t indent,
                const std::vector<const Property*>& written, const Document* kept,
                const std::vector<const Document::Node*>& unknown) {
        if (written.empty() && unknown.empty()) return;
        members.key(key);
        Members inside(out_, indent);
        for (const Property* property : written) value(handle, *property, inside, indent + 2);
        if (kept != nullptr)
            for (const Document::Node* node : unknown)
                inside.raw(kept->key(*node), kept->raw(*node));
        inside.close();
    }

    void value(Handle handle, const Property& property, Members& members, std::size_t indent) {
        try {
            const std::size_t column = members.key(property.name);
            if (column == std::string::npos) {
                throw Error(ErrorKind::bad_name, "a file cannot hold a name that is not UTF-8");
            }
            const std::size_t begin = out_.size();
            if (given_ != nullptr)
                out_ += *given_->value(handle, property.name);
            else if (const Formula* formula = tree_.formula(handle, property))
                this->formula(handle, property, *formula, column, indent);
            else
                values_.append(out_, property, tree_.get(handle, property), column, indent);
            if (noted_ != nullptr) noted_->set(handle, property, out_.substr(begin));
        } catch (const Error& e) {
            const std::string path = tree_.path(handle, property);
            const std::string reason = e.what();
            throw Error(e.kind(), reason.starts_with(path) ? reason : path + ": " + reason);
        }
    }

    /// The last value of a formula, if a write would accept it. A formula that has had no value yet
    /// leaves the one that the property is computed to, which may be out of range.
    std::optional<Value> last_value(Handle handle, const Property& property) const {
        (void)tree_.problem(handle, property);  // settles it; after an error the last value stays
        Value value = tree_.peek(handle, property);
        try {
            if (!value.is_nil()) (void)tree_.coerce(handle, property, value);
        } catch (const Error&) {
            return std::nullopt;
        }
        return value;
    }

    /// Why the text of the formula would not give the same formula; "" if it does.
    static std::string why_not_saved(const Formula& formula) {
        if (!formula.not_saved.empty()) return formula.not_saved;
        if (formula.source.empty()) return "has no text";
        std::string quoted;
        return append_quoted(quoted, formula.source) ? "" : "is not UTF-8";
    }

    void warn(Handle handle, const Property& property, const std::string& why,
              const std::string& consequence) {
        if (warnings_ != nullptr)
            warnings_->push_back(tree_.path(handle, property) + ": its formula " + why +
                                 ", so it cannot be saved; " + consequence);
    }

    /// Whether there is something to write for the property. A formula that cannot be saved, and
    /// whose value could not be loaded, is left out with a warning.
    bool has_text(Handle handle, const Property& property) {
        const Formula* const formula = given_ ? nullptr : tree_.formula(handle, property);
        if (formula == nullptr) return true;
        const std::string why = why_not_saved(*formula);
        if (why.empty() || last_value(handle, property)) return true;
        warn(handle, property, why, "it has had no value yet, so none is saved");
        return false;
    }

    /// Writes the formula as its text. If the text would not give the same formula, writes the
    /// value.
    void formula(Handle handle, const Property& property, const Formula& formula,
                 std::size_t column, std::size_t indent) {
        const Value value = last_value(handle, property).value_or(Value());
        const std::string why = why_not_saved(formula);
        if (why.empty() && values_.append(out_, property, formula, value)) return;
        values_.append(out_, property, value, column, indent);
        warn(handle, property, why,
             "its value " + tree_.text(value, property.precision()) + " is saved instead");
    }

    template <class Unknown>
    std::vector<const Document::Node*> kept_in(const Document* kept, std::string_view place,
                                               Unknown is_unknown) const {
        std::vector<const Document::Node*> nodes;
        const Document::Node* object = kept ? kept->member(kept->root(), place) : nullptr;
        if (object == nullptr || object->kind != Document::Kind::object) return nodes;
        for (const auto* node = kept->first(*object); node; node = kept->next(*node)) {
            if (is_unknown(kept->key(*node))) nodes.push_back(node);
        }
        return nodes;
    }

    void other_keys(Handle handle, Members& members, const Document& kept) {
        for (const auto* node = kept.first(kept.root()); node; node = kept.next(*node)) {
            const std::string& key = kept.key(*node);
            if (std::find(instance_keys.begin(), instance_keys.end(), key) != instance_keys.end()) {
                continue;
            }
            if (handle == top_ && key == version_key) continue;
            members.raw(key, kept.raw(*node));
        }
    }

    void children(Handle handle, Members& members, std::size_t indent, std::size_t depth) {
        bool first = true;
        for (Handle child = tree_.first_child(handle); child; child = tree_.next_sibling(child)) {
            if (left_out_ && left_out_(child)) continue;
            if (first) members.key("children");
            out_ += first ? "[\n" : ",\n";
            first = false;
            out_.append(indent + 2, ' ');
            instance(child, indent + 2, depth + 1);
        }
        if (first) return;
        out_ += '\n';
        out_.append(indent, ' ');
        out_ += ']';
    }

    const Tree& tree_;
    Handle top_;
    std::vector<std::string>* warnings_;
    ValueWriter values_;
    std::function<bool(Handle)> left_out_;
    SceneValues* noted_;
    const SceneValues* given_;  // null: the values that the tree has now are written
    std::string out_;
};

}  // namespace

std::string scene_text(const Tree& tree, Handle node, std::vector<std::string>* warnings) {
    std::string text = SceneWriter(tree, node, node, warnings).run();
    // The text is parsed as a test, so that no unreadable file is written.
    const Document check(text, tree.path(node));
    return text;
}

std::string scene_text_with_full_paths(const Tree& tree, Handle node,
                                       std::vector<std::string>* warnings,
                                       const std::function<bool(Handle)>& left_out,
                                       SceneValues* noted) {
    return SceneWriter(tree, node, {}, warnings, left_out, noted).run();
}

std::string scene_text_with_values(const Tree& tree, Handle node, const SceneValues& values) {
    const auto left_out = [&](Handle instance) { return !values.has(instance); };
    return SceneWriter(tree, node, {}, nullptr, left_out, nullptr, &values).run();
}

void save_scene(const Tree& tree, Handle node, const std::filesystem::path& file,
                std::vector<std::string>* warnings) {
    replace_file(file, scene_text(tree, node, warnings));
}

}  // namespace fettle::property
