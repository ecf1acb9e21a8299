// From a file into the tree: read the whole description and check its shape; create every instance,
// detached; assign values, then those that name instances (so that a reference may point forward);
// attach; tell `ready`. Until it is attached nothing of it is in the tree, and a failure removes
// it.

#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>

#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>

#include "document.h"
#include "durable_file.h"
#include "scene_reference.h"
#include "scene_value.h"
#include "unknown_keys.h"

namespace fettle::property {

namespace {

using Node = Document::Node;
using Kind = Document::Kind;

/// Destroys what was built, unless it was let go.
class Detached {
  public:
    explicit Detached(Tree& tree) : tree_(tree) {}
    ~Detached() {
        if (top && tree_.alive(top)) tree_.destroy(top);
    }
    Detached(const Detached&) = delete;
    Detached& operator=(const Detached&) = delete;
    Handle top;

  private:
    Tree& tree_;
};

std::string in_quotes(std::string_view text) {
    return value_text(Value(text));
}

class SceneLoader {
  public:
    SceneLoader(Tree& tree, const Document& document, Handle parent, std::string_view name,
                std::vector<std::string>* warnings, std::vector<SceneInstance>* described)
        : tree_(tree),
          document_(document),
          parent_(parent),
          name_(name),
          warnings_(warnings),
          described_(described),
          locate_([this] { return place(); }),
          resolve_([this](const std::string& path, const Node& node) {
              return find_reference(
                  {tree_, document_, instances_.front().handle, parent_, top_name()}, path, node);
          }) {}

    Handle run() {
        if (parent_) tree_.require(parent_);
        check_version();
        plan(document_.root(), none);
        Tree::CauseScope cause(tree_, Writer::load, &locate_);
        Detached detached(tree_);
        allocate(detached);
        // Formulas last: a plain value would replace them.
        for (const Pass pass : {Pass::values, Pass::references, Pass::formulas})
            for (Instance& instance : instances_) assign(instance, pass);
        for (Instance& instance : instances_) keep(instance);
        now_ = &document_.root();
        if (parent_) tree_.move(detached.top, parent_, name_);
        const Handle top = std::exchange(detached.top, Handle{});
        tell_ready(top);
        if (warnings_ != nullptr) {
            warnings_->insert(warnings_->end(), new_warnings_.begin(), new_warnings_.end());
        }
        describe();
        return top;
    }

  private:
    static constexpr std::size_t none = SIZE_MAX;

    enum class Pass { values, references, formulas };

    struct Instance {
        const Node* node;
        std::size_t parent;
        const Class* instance_class;
        const Node* name = nullptr;
        const Node* properties = nullptr;
        const Node* ad_hoc = nullptr;
        std::size_t place = 0;  // among its parent's children
        Handle handle{};
        UnknownKeys unknown{};
        std::unordered_set<const Node*> set_aside{};  // of its ad-hoc ones
    };

    // --- Messages

    /// "level.json:12", for whoever asks who wrote a value.
    std::string place() const {
        return document_.file_name() + ":" + std::to_string(document_.line(now_->begin));
    }

    /// Where the scene's top will be.
    std::string future_path(const std::string& name) const {
        if (!parent_) return name;
        const std::string suffix = path_suffix(name);
        if (parent_ == tree_.root() && suffix.starts_with('.')) return name;
        return tree_.path(parent_) + suffix;
    }
    std::string future_path() const { return future_path(top_name()); }
    std::string top_name() const {
        if (!name_.empty()) return name_;
        const Instance& top = instances_.front();
        if (top.name != nullptr) return document_.text(*top.name);
        return top.instance_class->stem();
    }
    std::string path(std::size_t index) const {
        const Instance& instance = instances_[index];
        if (instance.parent == none) return future_path();
        const std::string name = instance.handle            ? tree_.name(instance.handle)
                                 : instance.name != nullptr ? document_.text(*instance.name)
                                                            : instance.instance_class->stem();
        return path(instance.parent) + path_suffix(name);
    }
    std::size_t index(const Instance& instance) const {
        return static_cast<std::size_t>(&instance - instances_.data());
    }

    [[noreturn]] void fail(ErrorKind kind, std::size_t offset, const std::string& reason) const {
        document_.fail(kind, offset, reason);
    }
    /// What the tree said, with the place in the file. The tree knows the instances as detached;
    /// the reader of the message knows them by where they will be.
    [[noreturn]] void fail(const Error& error, std::size_t offset, const std::string& path,
                           Handle top) const {
        std::string reason = error.what();
        if (top && tree_.alive(top)) {
            const std::string detached = tree_.path(top);
            const std::string future = future_path();
            for (std::size_t at = reason.find(detached);
                 detached.starts_with('(') && at != std::string::npos;
                 at = reason.find(detached, at + future.size())) {
                reason.replace(at, detached.size(), future);
            }
        }
        fail(error.kind(), offset, reason.starts_with(path) ? reason : path + ": " + reason);
    }
    void warn(std::size_t offset, const std::string& text) {
        try {
            document_.fail(ErrorKind::unknown_name, offset, text);
        } catch (const SceneError& e) {
            new_warnings_.emplace_back(e.what());
        }
    }

    // --- Reading the description

    void check_version() const {
        const Node& root = document_.root();
        if (root.kind != Kind::object) {
            fail(ErrorKind::bad_structure, root.begin,
                 "expected a scene, that is an object, got " + std::string(kind_words(root.kind)));
        }
        const Node* version = document_.member(root, version_key);
        if (version == nullptr) {
            fail(ErrorKind::bad_structure, root.begin,
                 "not a scene: the key " + in_quotes(version_key) +
                     " with the version of the format is missing");
        }
        if (version->kind != Kind::integer || version->integer < 1) {
            fail(ErrorKind::bad_structure, version->begin,
                 "the version of the format must be an integer of at least 1");
        }
        if (version->integer > scene_format_version) {
            fail(ErrorKind::bad_structure, version->begin,
                 "this scene is in version " + std::to_string(version->integer) +
                     " of the format, and this program reads up to version " +
                     std::to_string(scene_format_version) + ": it needs a newer one");
        }
    }

    void plan(const Node& node, std::size_t parent) {
        if (node.kind != Kind::object) {
            fail(ErrorKind::bad_structure, node.begin,
                 "expected an instance, that is an object, got " +
                     std::string(kind_words(node.kind)));
        }
        const std::size_t self = instances_.size();
        instances_.push_back({&node, parent, &class_of(node, parent)});
        const Node* children = nullptr;
        for (const Node* member = document_.first(node); member; member = document_.next(*member)) {
            const std::string& key = document_.key(*member);
            Instance& instance = instances_[self];
            if (key == "class" || (key == version_key && parent == none)) continue;
            if (key == "name") {
                instance.name = &of_kind(*member, Kind::text);
                if (document_.text(*member).empty()) {
                    fail(ErrorKind::bad_name, member->begin, "a name cannot be empty");
                }
            } else if (key == "properties") {
                instance.properties = &of_kind(*member, Kind::object);
            } else if (key == "ad_hoc") {
                instance.ad_hoc = &of_kind(*member, Kind::object);
            } else if (key == "children") {
                children = &of_kind(*member, Kind::array);
            } else {
                other_key(instance, *member);
            }
        }
        if (children == nullptr) return;
        std::size_t place_of_child = 0;
        for (const Node* child = document_.first(*children); child;
             child = document_.next(*child)) {
            const std::size_t made = instances_.size();
            plan(*child, self);
            instances_[made].place = place_of_child++;
            const Node* name = document_.member(*child, "name");
            if (name != nullptr && !names_.emplace(self, document_.text(*name)).second) {
                fail(ErrorKind::bad_name, name->begin,
                     path(self) + " has two children called " + in_quotes(document_.text(*name)));
            }
        }
    }

    const Class& class_of(const Node& node, std::size_t parent) const {
        const Node* name = document_.member(node, "class");
        if (name == nullptr) {
            std::string reason = "expected an instance, but there is no key \"class\"";
            for (const Node* other = document_.first(node); other; other = document_.next(*other)) {
                if (near_miss(document_.key(*other), "class")) {
                    reason += ", only " + in_quotes(document_.key(*other));
                }
            }
            fail(ErrorKind::bad_structure, node.begin, reason);
        }
        of_kind(*name, Kind::text);
        try {
            return tree_.class_named(document_.text(*name));
        } catch (const Error& e) {
            const Node* own = document_.member(node, "name");
            std::string where = parent == none ? "" : path(parent);
            if (parent == none && !name_.empty()) {
                where = future_path(name_);
            } else if (own != nullptr && own->kind == Kind::text) {
                const std::string& text = document_.text(*own);
                where = parent == none ? future_path(text) : where + path_suffix(text);
            }
            fail(e.kind(), name->begin, (where.empty() ? "" : where + ": ") + e.what());
        }
    }

    const Node& of_kind(const Node& member, Kind kind) const {
        if (member.kind == kind) return member;
        fail(ErrorKind::bad_structure, member.begin,
             in_quotes(document_.key(member)) + " must be " + std::string(kind_words(kind)) +
                 ", not " + std::string(kind_words(member.kind)));
    }

    /// Keys of the format come with its version, so one that is nearly such a key is a slip, and
    /// keeping a "childern" aside would lose all that is in it.
    void other_key(Instance& instance, const Node& member) const {
        const std::string& key = document_.key(member);
        for (const std::string_view known : instance_keys) {
            if (near_miss(key, known)) {
                fail(ErrorKind::near_miss, member.key_begin,
                     path(index(instance)) + ": an instance has no key " + in_quotes(key) +
                         " (did you mean " + in_quotes(known) + "?)");
            }
        }
        instance.unknown.add(UnknownKeys::Place::instance, document_, member);
    }

    // --- Building

    void allocate(Detached& detached) {
        for (Instance& instance : instances_) {
            now_ = instance.node;
            const bool top = instance.parent == none;
            const Handle parent = top ? Handle{} : instances_[instance.parent].handle;
            const std::string name = top && !name_.empty()      ? name_
                                     : instance.name != nullptr ? document_.text(*instance.name)
                                     : top                      ? std::string()
                                                                : free_name(instance);
            const std::size_t offset =
                instance.name != nullptr ? instance.name->begin : instance.node->begin;
            const std::string where = path(index(instance));
            try {
                instance.handle = found_or_created(instance, parent, name);
            } catch (const Error& e) {
                fail(e, offset, where, detached.top);
            }
            if (top) detached.top = instance.handle;
        }
    }

    /// As a constructor calls a child that is given no name: `circle`, `circle_2`. Names in the
    /// file come first, wherever they stand.
    std::string free_name(const Instance& instance) {
        const Handle parent = instances_[instance.parent].handle;
        const std::string& stem = instance.instance_class->stem();
        std::size_t& number = numbers_[{instance.parent, stem}];
        std::string name;
        do name = ++number == 1 ? stem : stem + "_" + std::to_string(number);
        while (names_.contains({instance.parent, name}) || tree_.child(parent, name) ||
               tree_.find(parent, name) != nullptr ||
               tree_.class_of(parent).method(name) != nullptr);
        return name;
    }

    /// An instance may make children of its own as it is created; the file then describes those.
    Handle found_or_created(const Instance& instance, Handle parent, const std::string& name) {
        const Class& wanted = *instance.instance_class;
        const Handle own = parent && !name.empty() ? tree_.child(parent, name) : Handle{};
        if (own) {
            if (&tree_.class_of(own) == &wanted) return own;
            throw Error(ErrorKind::bad_structure, "is made by its parent, as a " +
                                                      tree_.class_of(own).name() + ", not a " +
                                                      wanted.name());
        }
        if (!wanted.creatable()) {
            throw Error(ErrorKind::bad_structure, "a " + wanted.name() + " cannot be created");
        }
        return tree_.create(wanted, parent, name);
    }

    void assign(Instance& instance, Pass pass) {
        if (instance.properties != nullptr) {
            for (const Property* property : instance.instance_class->properties()) {
                const Node* node = document_.member(*instance.properties, property->name);
                if (node != nullptr) assign(instance, *property, *node, pass);
            }
        }
        if (instance.ad_hoc == nullptr) return;
        for (const Node* node = document_.first(*instance.ad_hoc); node;
             node = document_.next(*node)) {
            assign_ad_hoc(instance, *node, pass);
        }
    }

    /// The plain value that is to be assigned in this pass; null: none.
    const Node* value_in(const Node& node, Type type, Type element, Pass pass) const {
        if (pass == Pass::formulas) return nullptr;
        const bool references = names_instance(document_, node, type, element);
        if (references != (pass == Pass::references)) return nullptr;
        const FormulaText formula = formula_text(document_, node);
        return formula ? formula.value : &node;
    }

    void assign(const Instance& instance, const Property& property, const Node& node, Pass pass) {
        const Type type = declared_type(property);
        now_ = &node;
        try {
            if (property.binding.kind == BindingKind::node && property.transient) {
                throw Error(ErrorKind::read_only,
                            "is told by the keys of the instance and by where it stands, not as a "
                            "property");
            }
            if (const Node* value = value_in(node, type, property.element, pass))
                tree_.set(instance.handle, property,
                          read_value(document_, *value, type, property.element, resolve_));
            if (pass == Pass::formulas) assign_formula(instance, property.name, node);
        } catch (const SceneError& e) {
            throw with_path(e, instance, property.name);
        } catch (const Error& e) {
            fail(e, node.begin, path(index(instance)) + path_suffix(property.name),
                 instances_.front().handle);
        }
    }

    void assign_formula(const Instance& instance, const std::string& property, const Node& node) {
        const FormulaText formula = formula_text(document_, node);
        if (!formula) return;
        const Property* found = tree_.find(instance.handle, property);
        const Value value = found != nullptr ? tree_.peek(instance.handle, *found) : Value();
        Formula made;
        try {
            made = make_formula(tree_, document_.text(*formula.is), value);
        } catch (const Error& e) {
            fail(e.kind(), formula.is->begin, e.what());
        }
        tree_.set_formula(instance.handle, property, std::move(made));
    }

    void assign_ad_hoc(Instance& instance, const Node& node, Pass pass) {
        const std::string& key = document_.key(node);
        // A class may have learned to declare what was ad-hoc when the file was written.
        if (const Property* declared = instance.instance_class->property(key)) {
            assign(instance, *declared, node, pass);
            return;
        }
        if (instance.set_aside.contains(&node)) return;
        now_ = &node;
        const std::string where = path(index(instance)) + path_suffix(key);
        try {
            if (const Node* value = value_in(node, Type::nil, Type::nil, pass))
                tree_.set_or_add(instance.handle, key,
                                 read_value(document_, *value, Type::nil, Type::nil, resolve_));
            if (pass == Pass::formulas) assign_formula(instance, key, node);
        } catch (const SceneError& e) {
            throw with_path(e, instance, key);
        } catch (const Error& e) {
            const bool no_longer = e.kind() == ErrorKind::near_miss ||
                                   (e.kind() == ErrorKind::bad_name &&
                                    instance.instance_class->method(key) != nullptr);
            if (!no_longer) fail(e, node.begin, where, instances_.front().handle);
            warn(node.key_begin, where + ": " + instance.instance_class->name() +
                                     " now has something of nearly this name; kept as it is");
            instance.unknown.add(UnknownKeys::Place::ad_hoc, document_, node);
            instance.set_aside.insert(&node);
        }
    }

    SceneError with_path(const SceneError& e, const Instance& instance,
                         const std::string& property) const {
        const std::string place =
            e.file() + ":" + std::to_string(e.line()) + ":" + std::to_string(e.column()) + ": ";
        const std::string where = path(index(instance)) + path_suffix(property);
        return SceneError(e.kind(), e.file(), e.line(), e.column(),
                          where + ": " + std::string(e.what()).substr(place.size()));
    }

    /// Properties the class does not have are kept aside rather than added as ad-hoc ones: what a
    /// newer version of the class means by them is not for this one to say.
    void keep(Instance& instance) {
        if (instance.properties != nullptr) {
            const Class& its_class = *instance.instance_class;
            for (const Node* node = document_.first(*instance.properties); node;
                 node = document_.next(*node)) {
                const std::string& key = document_.key(*node);
                if (its_class.property(key) != nullptr) continue;
                const std::string meant = suggestion(key, its_class.member_names());
                warn(node->key_begin,
                     path(index(instance)) + ": " + its_class.name() + " has no property " +
                         in_quotes(key) + meant + "; kept as it is" +
                         (meant.empty() ? " (what is your own belongs under \"ad_hoc\")" : ""));
                instance.unknown.add(UnknownKeys::Place::properties, document_, *node);
            }
        }
        if (instance.unknown.empty()) return;
        now_ = instance.node;
        tree_.set_or_add(instance.handle, unknown_keys_property, instance.unknown.text());
    }

    void describe() const {
        if (described_ == nullptr) return;
        described_->clear();
        for (const Instance& instance : instances_)
            described_->push_back({.instance = instance.handle,
                                   .parent = instance.parent == none ? 0 : instance.parent,
                                   .place = instance.place});
    }

    void tell_ready(Handle handle) {
        for (const Handle child : tree_.children(handle)) tell_ready(child);
        if (const Event* ready = tree_.class_of(handle).event("ready")) {
            tree_.emit(handle, *ready, {});
        }
    }

    Tree& tree_;
    const Document& document_;
    Handle parent_;
    std::string name_;
    std::set<std::pair<std::size_t, std::string>> names_;                 // in the file, by parent
    std::map<std::pair<std::size_t, std::string>, std::size_t> numbers_;  // given, by stem
    std::vector<std::string>* warnings_;
    std::vector<SceneInstance>* described_;
    std::vector<std::string> new_warnings_;
    std::vector<Instance> instances_;
    const Node* now_ = nullptr;  // what is being assigned
    std::function<std::string()> locate_;
    ReferenceResolver resolve_;
};

}  // namespace

Handle load_scene_text(Tree& tree, std::string_view text, std::string_view file_name, Handle parent,
                       std::string_view name, std::vector<std::string>* warnings,
                       std::vector<SceneInstance>* instances) {
    const Document document{std::string(text), std::string(file_name)};
    return SceneLoader(tree, document, parent, name, warnings, instances).run();
}

Handle load_scene(Tree& tree, const std::filesystem::path& file, Handle parent,
                  std::string_view name, std::vector<std::string>* warnings,
                  std::vector<SceneInstance>* instances) {
    return load_scene_text(tree, read_file(file, Document::size_limit), file.string(), parent, name,
                           warnings, instances);
}

}  // namespace fettle::property
