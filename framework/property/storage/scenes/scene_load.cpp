// Loading a scene: reads the whole file and checks its structure; creates all instances detached;
// assigns the values, then the values with references (which may refer to later instances);
// attaches the scene; calls `ready`. Before it is attached, the tree does not contain any of it; an
// error removes it.

#include <map>
#include <string>
#include <unordered_set>
#include <utility>

#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>

#include <files/durable_file.h>
#include <json/document.h>
#include <scenes/scene_load.h>
#include <scenes/scene_plan.h>
#include <values/scene_reference.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

using Node = Document::Node;

/// Destroys the built instances, unless they were released.
class Detached {
  public:
    explicit Detached(Tree& tree) : tree_(tree) {}
    ~Detached() {
        if (top && tree_.alive(top)) try {
                tree_.destroy(top);
            } catch (const std::exception&) {  // the reason why the scene cannot be loaded is
                                               // reported instead
            }
    }
    Detached(const Detached&) = delete;
    Detached& operator=(const Detached&) = delete;
    Handle top;

  private:
    Tree& tree_;
};

class SceneLoader {
  public:
    SceneLoader(Tree& tree, const Document& document, Handle parent, std::string_view name,
                std::vector<std::string>* warnings, std::vector<SceneInstance>* described,
                std::vector<OpenReference>* open = nullptr,
                std::optional<Writer> writer = std::nullopt)
        : tree_(tree),
          document_(document),
          parent_(parent),
          name_(name),
          plan_(tree, document, parent, name),
          made_(plan_.instances.size()),
          warnings_(warnings),
          described_(described),
          open_(open),
          writer_(writer),
          locate_([this] { return place(); }),
          resolve_([this](const std::string& path, const Node& node) {
              return find_reference(
                  {tree_, document_, made_.front().handle, parent_, plan_.top_name()}, path, node);
          }) {}

    Handle run() {
        const Tree::CauseScope cause(tree_, writer_.value_or(Writer::load),
                                     writer_ ? nullptr : &locate_);
        Detached detached(tree_);
        for (std::size_t i = 0; i < made_.size(); ++i) allocate(i, detached);
        // Formulas are last, because a plain value would replace them. A parent gets its values
        // after its children, because a body changes its velocity when its center of mass moves.
        for (const Pass pass : {Pass::values, Pass::references, Pass::formulas})
            for (const std::size_t i : plan_.children_first()) assign(i, pass);
        for (std::size_t i = 0; i < made_.size(); ++i) keep(i);
        now_ = &document_.root();
        if (parent_) tree_.move(detached.top, parent_, name_);
        const Handle top = std::exchange(detached.top, Handle{});
        notify_ready(top);
        if (warnings_ != nullptr)
            warnings_->insert(warnings_->end(), plan_.warnings.begin(), plan_.warnings.end());
        describe();
        return top;
    }

  private:
    static constexpr std::size_t none = ScenePlan::none;
    using Planned = ScenePlan::Instance;

    enum class Pass { values, references, formulas };

    struct Made {
        Handle handle{};
        std::unordered_set<const Node*> set_aside{};  // ad-hoc properties that could not be set
    };

    // --- Messages

    /// "level.json:12", for the cause of a write.
    std::string place() const {
        return document_.file_name() + ":" + std::to_string(document_.line(now_->begin));
    }

    [[noreturn]] void fail(ErrorKind kind, std::size_t offset, const std::string& reason) const {
        document_.fail(kind, offset, reason);
    }
    /// Adds the place in the file to an error of the tree. The paths of detached instances are
    /// replaced by the paths that they are going to have.
    [[noreturn]] void fail(const Error& error, std::size_t offset, const std::string& path,
                           Handle top) const {
        std::string reason = error.what();
        if (top && tree_.alive(top)) {
            const std::string detached = tree_.path(top);
            const std::string future = plan_.top_path();
            for (std::size_t at = reason.find(detached);
                 detached.starts_with('(') && at != std::string::npos;
                 at = reason.find(detached, at + future.size())) {
                reason.replace(at, detached.size(), future);
            }
        }
        fail(error.kind(), offset, reason.starts_with(path) ? reason : path + ": " + reason);
    }

    // --- Building

    void allocate(std::size_t index, Detached& detached) {
        Planned& planned = plan_.instances[index];
        now_ = planned.node;
        const bool top = planned.parent == none;
        const Handle parent = top ? Handle{} : made_[planned.parent].handle;
        const std::string name = top && !name_.empty()     ? name_
                                 : planned.name != nullptr ? document_.text(*planned.name)
                                 : top                     ? std::string()
                                                           : free_name(planned);
        const std::size_t offset =
            planned.name != nullptr ? planned.name->begin : planned.node->begin;
        const std::string where = plan_.path(index);
        try {
            made_[index].handle = found_or_created(planned, parent, name);
        } catch (const Error& e) {
            fail(e, offset, where, detached.top);
        }
        planned.called = tree_.name(made_[index].handle);
        if (top) detached.top = made_[index].handle;
    }

    /// A generated name like that of a constructor without a name: `circle`, `circle_2`. Names in
    /// the file take precedence, wherever they are.
    std::string free_name(const Planned& planned) {
        const Handle parent = made_[planned.parent].handle;
        const std::string& stem = planned.instance_class->stem();
        std::size_t& number = numbers_[{planned.parent, stem}];
        std::string name;
        do name = ++number == 1 ? stem : stem + "_" + std::to_string(number);
        while (plan_.names_child(planned.parent, name) || tree_.child(parent, name) ||
               tree_.find(parent, name) != nullptr ||
               tree_.class_of(parent).method(name) != nullptr);
        return name;
    }

    /// An instance may make children when it is created; then the file describes those.
    Handle found_or_created(const Planned& planned, Handle parent, const std::string& name) {
        const Class& wanted = *planned.instance_class;
        const Handle own = parent && !name.empty() ? tree_.child(parent, name) : Handle{};
        if (own) {
            if (&tree_.class_of(own) == &wanted) return own;
            throw Error(ErrorKind::bad_structure, "is made by its parent, as " +
                                                      with_article(tree_.class_of(own).name()) +
                                                      ", not " + with_article(wanted.name()));
        }
        if (!wanted.creatable()) {
            throw Error(ErrorKind::bad_structure,
                        with_article(wanted.name()) + " cannot be created");
        }
        return tree_.create(wanted, parent, name);
    }

    void assign(std::size_t index, Pass pass) {
        const Planned& planned = plan_.instances[index];
        if (planned.properties != nullptr) {
            for (const Property* property : planned.instance_class->properties()) {
                const Node* node = document_.member(*planned.properties, property->name);
                if (node != nullptr) assign(index, *property, *node, pass);
            }
        }
        if (planned.ad_hoc == nullptr) return;
        for (const Node* node = document_.first(*planned.ad_hoc); node;
             node = document_.next(*node)) {
            assign_ad_hoc(index, *node, pass);
        }
    }

    /// The plain value that is assigned in this pass; null if there is none.
    const Node* value_in(const Node& node, Type type, Type element, Pass pass) const {
        if (pass == Pass::formulas) return nullptr;
        const bool references = names_instance(document_, node, type, element);
        if (references != (pass == Pass::references)) return nullptr;
        const FormulaText formula = formula_text(document_, node);
        return formula ? formula.value : &node;
    }

    void assign(std::size_t index, const Property& property, const Node& node, Pass pass) {
        const Type type = declared_type(property);
        const Handle handle = made_[index].handle;
        now_ = &node;
        try {
            require_settable_in_scene(property);
            if (const Node* value = value_in(node, type, property.element, pass))
                tree_.set(handle, property,
                          read_value(document_, *value, type, property.element, resolve_));
            if (pass == Pass::formulas) assign_formula(handle, property.name, node);
        } catch (const SceneError& e) {
            if (leave_to_caller(index, property.name, node, pass, e)) return;
            throw e.about(plan_.path(index) + path_suffix(property.name));
        } catch (const Error& e) {
            const std::string path = plan_.path(index) + path_suffix(property.name);
            if (!property.simulated || e.kind() != ErrorKind::rejected)
                fail(e, node.begin, path, made_.front().handle);
            // Another value in the file forbids it: `type = "static"` forbids a velocity.
            const std::string reason = e.what();
            plan_.warn(node.begin,
                       path + ": " + reason.substr(reason.find(": ") + 2) + "; it is left out");
        }
    }

    /// Returns whether a missing reference is left to the caller, which gets it in `open_`.
    bool leave_to_caller(std::size_t index, const std::string& property, const Node& node,
                         Pass pass, const SceneError& error) const {
        if (open_ == nullptr || pass != Pass::references || error.kind() != ErrorKind::unknown_name)
            return false;
        // The last value of a formula is not needed if the formula can be computed.
        if (!formula_text(document_, node) || !tree_.formula_compiler())
            open_->push_back({made_[index].handle, property, &node});
        return true;
    }

    void assign_formula(Handle handle, const std::string& property, const Node& node) {
        const FormulaText formula = formula_text(document_, node);
        if (!formula) return;
        const Property* found = tree_.find(handle, property);
        const Value value = found != nullptr ? tree_.peek(handle, *found) : Value();
        tree_.set_formula(handle, property, made_formula(tree_, document_, formula, value));
    }

    void assign_ad_hoc(std::size_t index, const Node& node, Pass pass) {
        Planned& planned = plan_.instances[index];
        Made& made = made_[index];
        const std::string& key = document_.key(node);
        // The class may declare a property that was ad-hoc when the file was written.
        if (const Property* declared = planned.instance_class->property(key)) {
            assign(index, *declared, node, pass);
            return;
        }
        if (made.set_aside.contains(&node)) return;
        now_ = &node;
        const std::string where = plan_.path(index) + path_suffix(key);
        try {
            if (const Node* value = value_in(node, Type::nil, Type::nil, pass))
                tree_.set_or_add(made.handle, key,
                                 read_value(document_, *value, Type::nil, Type::nil, resolve_));
            if (pass == Pass::formulas) assign_formula(made.handle, key, node);
        } catch (const SceneError& e) {
            if (leave_to_caller(index, key, node, pass, e)) return;
            throw e.about(where);
        } catch (const Error& e) {
            const bool no_longer =
                e.kind() == ErrorKind::near_miss ||
                (e.kind() == ErrorKind::bad_name && planned.instance_class->method(key) != nullptr);
            if (!no_longer) fail(e, node.begin, where, made_.front().handle);
            plan_.warn(node.key_begin, where + ": " + planned.instance_class->name() +
                                           " now has something of nearly this name; kept as it is");
            planned.unknown.add(UnknownKeys::Place::ad_hoc, document_, node);
            made.set_aside.insert(&node);
        }
    }

    /// Unknown properties are kept as text instead of becoming ad-hoc properties, because a newer
    /// version of the class may give them a meaning.
    void keep(std::size_t index) {
        Planned& planned = plan_.instances[index];
        if (planned.properties != nullptr) {
            const Class& its_class = *planned.instance_class;
            for (const Node* node = document_.first(*planned.properties); node;
                 node = document_.next(*node)) {
                if (its_class.property(document_.key(*node)) == nullptr)
                    planned.unknown.add(UnknownKeys::Place::properties, document_, *node);
            }
        }
        if (planned.unknown.empty()) return;
        now_ = planned.node;
        tree_.set_or_add(made_[index].handle, unknown_keys_property, planned.unknown.text());
    }

    void describe() const {
        if (described_ == nullptr) return;
        described_->clear();
        for (std::size_t i = 0; i < made_.size(); ++i) {
            const Planned& planned = plan_.instances[i];
            described_->push_back({.instance = made_[i].handle,
                                   .parent = planned.parent == none ? 0 : planned.parent,
                                   .place = planned.place});
        }
    }

    void notify_ready(Handle handle) {
        for (const Handle child : tree_.children(handle)) notify_ready(child);
        if (const Event* ready = tree_.class_of(handle).event("ready")) {
            tree_.emit(handle, *ready, {});
        }
    }

    Tree& tree_;
    const Document& document_;
    Handle parent_;
    std::string name_;
    ScenePlan plan_;
    std::vector<Made> made_;                                              // order of the plan
    std::map<std::pair<std::size_t, std::string>, std::size_t> numbers_;  // last one, by stem
    std::vector<std::string>* warnings_;
    std::vector<SceneInstance>* described_;
    std::vector<OpenReference>* open_;
    std::optional<Writer> writer_;  // none if a file is loaded
    const Node* now_ = nullptr;     // the value that is being assigned
    std::function<std::string()> locate_;
    ReferenceResolver resolve_;
};

}  // namespace

Handle load_scene_text(Tree& tree, std::string_view text, std::string_view file_name, Handle parent,
                       std::string_view name, std::vector<std::string>* warnings,
                       std::vector<SceneInstance>* instances) {
    const Document document{std::string(text), std::string(file_name)};
    if (parent) tree.require(parent);
    return SceneLoader(tree, document, parent, name, warnings, instances).run();
}

Handle load_scene_document(Tree& tree, const Document& document, Handle parent,
                           std::string_view name, std::vector<OpenReference>& open) {
    return SceneLoader(tree, document, parent, name, nullptr, nullptr, &open).run();
}

Handle make_scene(Tree& tree, const Document& document, Handle parent, std::string_view name,
                  std::vector<OpenReference>& open) {
    return SceneLoader(tree, document, parent, name, nullptr, nullptr, &open, tree.cause().writer)
        .run();
}

Handle load_scene(Tree& tree, const std::filesystem::path& file, Handle parent,
                  std::string_view name, std::vector<std::string>* warnings,
                  std::vector<SceneInstance>* instances) {
    return load_scene_text(tree, read_file(file, Document::size_limit), file.string(), parent, name,
                           warnings, instances);
}

}  // namespace fettle::property
