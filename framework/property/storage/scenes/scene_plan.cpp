#include <scenes/scene_plan.h>

#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>

namespace fettle::property {

bool may_be_given(std::string_view name, const Class& its) {
    if (!name.starts_with(its.stem())) return false;
    const std::string_view number = name.substr(its.stem().size());
    return number.empty() || (number.size() > 1 && number.front() == '_' &&
                              number.find_first_not_of("0123456789", 1) == std::string_view::npos);
}

namespace {

std::string in_quotes(std::string_view text) {
    return value_text(Value(text));
}

}  // namespace

ScenePlan::ScenePlan(const Tree& tree, const Document& document, Handle parent,
                     std::string_view name)
    : tree_(tree), document_(document), parent_(parent), name_(name) {
    check_version();
    read(document_.root(), none);
}

// --- Paths, for messages -------------------------------------------------------------------------

std::string ScenePlan::future_path(const std::string& name) const {
    if (!parent_) return name;
    const std::string suffix = path_suffix(name);
    if (parent_ == tree_.root() && suffix.starts_with('.')) return name;
    return tree_.path(parent_) + suffix;
}

std::string ScenePlan::top_name() const {
    if (!name_.empty()) return name_;
    const Instance& top = instances.front();
    if (top.name != nullptr) return document_.text(*top.name);
    return top.instance_class->stem();
}

std::string ScenePlan::path(std::size_t index) const {
    const Instance& instance = instances[index];
    if (instance.parent == none) return top_path();
    const std::string name = !instance.called.empty()   ? instance.called
                             : instance.name != nullptr ? document_.text(*instance.name)
                                                        : instance.instance_class->stem();
    return path(instance.parent) + path_suffix(name);
}

std::vector<std::size_t> ScenePlan::children_first() const {
    std::vector<std::size_t> list, open;
    const auto close = [&] {
        list.push_back(open.back());
        open.pop_back();
    };
    for (std::size_t i = 0; i < instances.size(); ++i) {
        while (!open.empty() && open.back() != instances[i].parent) close();
        open.push_back(i);
    }
    while (!open.empty()) close();
    return list;
}

void ScenePlan::warn(std::size_t offset, const std::string& text) {
    try {
        document_.fail(ErrorKind::unknown_name, offset, text);
    } catch (const SceneError& e) {
        warnings.emplace_back(e.what());
    }
}

// --- Reading -------------------------------------------------------------------------------------

void ScenePlan::check_version() const {
    const Node& root = document_.root();
    if (root.kind != Document::Kind::object)
        document_.fail(
            ErrorKind::bad_structure, root.begin,
            "expected a scene, that is an object, got " + std::string(kind_words(root.kind)));
    const Node* version = document_.member(root, version_key);
    if (version == nullptr) {
        std::string reason = "not a scene: the key " + in_quotes(version_key) +
                             " with the version of the format is missing";
        for (const Node* other = document_.first(root); other; other = document_.next(*other))
            if (near_miss(document_.key(*other), version_key))
                reason += ", there is only " + in_quotes(document_.key(*other));
        document_.fail(ErrorKind::bad_structure, root.begin, reason);
    }
    if (version->kind != Document::Kind::integer || version->integer < 1)
        document_.fail(ErrorKind::bad_structure, version->begin,
                       "the version of the format must be an integer of at least 1");
    if (version->integer > scene_format_version)
        document_.fail(ErrorKind::bad_structure, version->begin,
                       "this scene is in version " + std::to_string(version->integer) +
                           " of the format, and this program reads up to version " +
                           std::to_string(scene_format_version) + ": it needs a newer one");
}

void ScenePlan::read(const Node& node, std::size_t parent) {
    if (node.kind != Document::Kind::object)
        document_.fail(
            ErrorKind::bad_structure, node.begin,
            "expected an instance, that is an object, got " + std::string(kind_words(node.kind)));
    const std::size_t self = instances.size();
    instances.push_back({&node, parent, &class_of(node, parent)});
    // The name is read first, because messages about earlier members contain it.
    if (const Node* name = document_.member(node, "name")) {
        if (document_.text(of_kind(*name, Document::Kind::text)).empty())
            document_.fail(ErrorKind::bad_name, name->begin, "a name cannot be empty");
        instances[self].name = name;
    }
    const Node* children = nullptr;
    for (const Node* member = document_.first(node); member; member = document_.next(*member)) {
        const std::string& key = document_.key(*member);
        if (key == "class" || key == "name" || (key == version_key && parent == none)) continue;
        if (key == "properties")
            instances[self].properties = &of_kind(*member, Document::Kind::object);
        else if (key == "ad_hoc")
            instances[self].ad_hoc = &of_kind(*member, Document::Kind::object);
        else if (key == "children")
            children = &of_kind(*member, Document::Kind::array);
        else
            other_key(self, *member);
    }
    check_nesting(self, instances[self].properties);
    check_nesting(self, instances[self].ad_hoc);
    warn_of_unknown_properties(self);
    if (children != nullptr) read_children(*children, self);
}

void ScenePlan::read_children(const Node& children, std::size_t parent) {
    std::size_t place = 0;
    for (const Node* child = document_.first(children); child; child = document_.next(*child)) {
        const std::size_t made = instances.size();
        read(*child, parent);
        instances[made].place = place++;
        const Node* name = instances[made].name;
        if (name != nullptr && !names_.emplace(parent, document_.text(*name)).second)
            document_.fail(
                ErrorKind::bad_name, name->begin,
                path(parent) + " has two children called " + in_quotes(document_.text(*name)));
    }
}

const Class& ScenePlan::class_of(const Node& node, std::size_t parent) const {
    const Node* name = document_.member(node, "class");
    if (name == nullptr) {
        std::string reason = "expected an instance, but there is no key \"class\"";
        for (const Node* other = document_.first(node); other; other = document_.next(*other))
            if (near_miss(document_.key(*other), "class"))
                reason += ", only " + in_quotes(document_.key(*other));
        document_.fail(ErrorKind::bad_structure, node.begin, reason);
    }
    of_kind(*name, Document::Kind::text);
    try {
        return tree_.class_named(document_.text(*name));
    } catch (const Error& e) {
        const Node* own = document_.member(node, "name");
        std::string where = parent == none ? "" : path(parent);
        if (parent == none && !name_.empty()) {
            where = future_path(name_);
        } else if (own != nullptr && own->kind == Document::Kind::text) {
            const std::string& text = document_.text(*own);
            where = parent == none ? future_path(text) : where + path_suffix(text);
        }
        document_.fail(e.kind(), name->begin, (where.empty() ? "" : where + ": ") + e.what());
    }
}

const Document::Node& ScenePlan::of_kind(const Node& member, Document::Kind kind) const {
    if (member.kind == kind) return member;
    document_.fail(ErrorKind::bad_structure, member.begin,
                   in_quotes(document_.key(member)) + " must be " + std::string(kind_words(kind)) +
                       ", not " + std::string(kind_words(member.kind)));
}

// --- Misplaced keys ------------------------------------------------------------------------------

/// Keys of the format only change with its version. So a key that is nearly one of them is a
/// mistake: keeping "childern" as an unknown key would lose its content. A property beside the
/// class is a mistake, too: the instance would be made without it. Every other key is kept.
void ScenePlan::other_key(std::size_t index, const Node& member) {
    const std::string& key = document_.key(member);
    const Class& of = *instances[index].instance_class;
    const std::string subject = path(index) + ": an instance has no key " + in_quotes(key);
    const auto fail = [&](const std::string& reason) {
        document_.fail(ErrorKind::near_miss, member.key_begin, subject + reason);
    };
    const auto belongs = [&](const std::string& name) {
        const Property& property = *of.property(name);
        const bool settable = !property.read_only && property.binding.kind != BindingKind::node;
        return "is a property of " + of.name() +
               (settable ? " and belongs inside \"properties\"" : ", which no scene file sets");
    };
    if (of.property(key) != nullptr) fail("; it " + belongs(key));
    if (key == version_key) fail(": it stands once, in the topmost object of the file");
    for (const std::string_view known : instance_keys)
        if (near_miss(key, known)) fail(" (did you mean " + in_quotes(known) + "?)");
    std::vector<std::string> names;
    for (const Property* property : of.properties()) names.push_back(property->name);
    for (const std::string& name : names)
        if (near_miss(key, name))
            fail(" (did you mean " + in_quotes(name) + "? It " + belongs(name) + ")");
    names.insert(names.end(), instance_keys.begin(), instance_keys.end());
    const std::string meant = suggestion(key, names);
    // An object is a note of an editor; a value was meant for the instance.
    if (!meant.empty() || member.kind != Document::Kind::object)
        warn(member.key_begin,
             subject + meant + "; kept as it is" +
                 (meant.empty() ? " (what is your own belongs under \"ad_hoc\")" : ""));
    instances[index].unknown.add(UnknownKeys::Place::instance, document_, member);
}

void ScenePlan::warn_of_unknown_properties(std::size_t index) {
    const Node* const section = instances[index].properties;
    const Class& of = *instances[index].instance_class;
    for (const Node* node = section != nullptr ? document_.first(*section) : nullptr; node;
         node = document_.next(*node)) {
        const std::string& key = document_.key(*node);
        if (of.property(key) != nullptr) continue;
        const std::string meant = suggestion(key, of.member_names());
        warn(node->key_begin,
             path(index) + ": " + of.name() + " has no property " + in_quotes(key) + meant +
                 "; kept as it is" +
                 (meant.empty() ? " (what is your own belongs under \"ad_hoc\")" : ""));
    }
}

/// Warns about instances, and sections of an instance, inside a section. They would be ignored
/// there.
void ScenePlan::check_nesting(std::size_t index, const Node* section) const {
    if (section == nullptr) return;
    const bool declared = document_.key(*section) == "properties";
    const auto is_instance = [&](const Node* node) {
        return node != nullptr && document_.member(*node, "class") != nullptr;
    };
    for (const Node* node = document_.first(*section); node; node = document_.next(*node)) {
        const std::string& key = document_.key(*node);
        if (instances[index].instance_class->property(key) != nullptr) continue;
        const auto fail = [&](const char* where) {
            document_.fail(ErrorKind::bad_structure, node->key_begin,
                           path(index) + ": " + in_quotes(key) + " stands inside " +
                               in_quotes(document_.key(*section)) + " and belongs " + where);
        };
        if (is_instance(node)) fail("into the list \"children\" of the instance");
        const bool is_section =
            (key == "children" && node->kind == Document::Kind::array &&
             (document_.first(*node) == nullptr || is_instance(document_.first(*node)))) ||
            ((key == "properties" || key == "ad_hoc") && node->kind == Document::Kind::object &&
             (declared || document_.count(*node) != 1)) ||
            key == version_key;
        if (is_section) fail("beside it, into the object of the instance");
    }
}

}  // namespace fettle::property
