// Applies kept tweaks from their file to the tree.

#include <cstdint>
#include <utility>

#include <fettle/property/located_writes.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>

#include <scenes/scene_load.h>
#include <tweaks_file/kept_tweaks.h>
#include <values/scene_reference.h>
#include <values/scene_value.h>

namespace fettle::property {

void KeptTweaks::warn(std::size_t offset, const std::string& reason) {
    warn(*document_, offset, reason);
}

void KeptTweaks::warn(const Document& document, std::size_t offset, const std::string& reason) {
    try {
        document.fail(ErrorKind::rejected, offset, reason);
    } catch (const SceneError& error) {
        report(error);
    }
}

void KeptTweaks::report(const SceneError& error) {
    if (reported_.insert(error.what()).second) warn_(error.what());
}

const KeptTweaks::Node* KeptTweaks::member(std::string_view section, const std::string& key) const {
    const Node* object = document_->member(document_->root(), section);
    return object == nullptr ? nullptr : document_->member(*object, key);
}

std::string KeptTweaks::place_of(const std::string& instance, const std::string& property) const {
    const auto found = contents_.values.find(instance);
    if (found == contents_.values.end() || document_ == nullptr) return {};
    for (const Kept& each : found->second)
        if (each.property == property)
            if (const Node* const node = member("values", each.key))
                return file_.filename().string() + ":" +
                       std::to_string(document_->line(node->begin));
    return {};
}

/// Notes what a script has written since the last kept value was assigned, for those with a value
/// that scripts gave before.
void KeptTweaks::note_given_now(const Assignment& to) {
    if (document_ == nullptr || member("given", to.path) == nullptr) return;
    const Property* const property = tree_.find(to.instance, to.property);
    if (property == nullptr) return;
    const Provenance written = tree_.last_writer(to.instance, *property);
    if (written.known && written.cause.writer == Writer::load) return;
    const Image image = image_now(tree_, to.instance, property->symbol, false);
    Given& now = given_now_[to.path];
    now = {};
    if (image.kind != Image::Kind::value) return;
    const Property* const declared = tree_.class_of(to.instance).property(to.property);
    now = {.value = image_in_file(tree_, declared, image, {}),
           .text = image.text,
           .unit = property->unit.empty() ? "" : " " + property->unit,
           .place = written.known ? written.cause.where : std::string(),
           .instance = to.instance,
           .property = property->symbol};
}

std::string KeptTweaks::text_for_people(const Node& node, const Given& of) const {
    std::string raw(document_->raw(node));
    const Property* const property = tree_.find(of.instance, of.property);
    if (property == nullptr) return raw;
    try {
        if (const FormulaText formula = formula_text(*document_, node))
            return "is " + document_->text(*formula.is);
        const Value value =
            read_value(*document_, node, declared_type(*property), property->element,
                       [&](const std::string&, const Node&) -> Handle {
                           throw Error(ErrorKind::unknown_name, raw);
                       });
        return tree_.text(value, property->precision());
    } catch (const Error&) {
        return raw;
    }
}

/// A person who has kept a value should know that the script gives another one meanwhile: the kept
/// value hides it.
void KeptTweaks::compare_with_given() {
    for (const auto& [key, now] : given_now_) {
        const Node* const given = member("given", key);
        const Node* const kept = member("values", key);
        if (given == nullptr || kept == nullptr || now.value.empty()) continue;
        const std::string before(document_->raw(*given));
        if (before == now.value) continue;
        warn_((now.place.empty() ? std::string("a script") : now.place) + " now gives " + key +
              " " + now.text + now.unit + "; it gave " + text_for_people(*given, now) + " when " +
              text_for_people(*kept, now) + " was kept, which " + file_.filename().string() + ":" +
              std::to_string(document_->line(kept->begin)) + " still sets");
    }
}

/// Assigns the value. False if it refers to an instance that does not exist; if `last`, that is
/// reported.
bool KeptTweaks::assign(const Assignment& to, bool last) {
    const Document& document = *to.document;
    const Node& node = *to.node;
    if (!applied_) note_given_now(to);
    std::function<std::string()> locate = [&] {
        return file_.filename().string() + ":" + std::to_string(document.line(node.begin));
    };
    const Tree::CauseScope cause(tree_, Writer::load, &locate);
    const LocatedWrites located(tree_);
    try {
        const Property* found = tree_.find(to.instance, to.property);
        const Type type = found != nullptr ? declared_type(*found) : Type::nil;
        const Type element = found != nullptr ? found->element : Type::nil;
        const FormulaText formula = formula_text(document, node);
        const Node* plain = formula ? formula.value : &node;
        if (!formula && plain->kind == Document::Kind::null && found != nullptr &&
            !found->nullable) {
            tree_.set(to.instance, *found, {});
            return true;
        }
        // The stored value of a formula is used only if the formula cannot be compiled.
        if (formula && tree_.formula_compiler()) plain = nullptr;
        Value value;
        if (plain != nullptr)
            value = read_value(
                document, *plain, type, element, [&](const std::string& path, const Node& at) {
                    return find_reference({tree_, document, to.top, {}, {}}, path, at);
                });
        if (formula)
            tree_.set_formula(to.instance, to.property,
                              make_formula(tree_, document.text(*formula.is), value));
        else
            tree_.set_or_add(to.instance, to.property, value);
    } catch (const SceneError& error) {
        if (!last && error.kind() == ErrorKind::unknown_name) return false;
        report(error.about(to.path));
    } catch (const Error& error) {
        warn(document, node.begin, error.what());
    }
    return true;
}

void KeptTweaks::assign_or_wait(Assignment to) {
    if (!assign(to, false)) waiting_.push_back(std::move(to));
}

void KeptTweaks::try_waiting(bool last) {
    std::vector<Assignment> waiting = std::exchange(waiting_, {});
    for (Assignment& each : waiting)
        if (tree_.alive(each.instance) && !assign(each, last)) waiting_.push_back(std::move(each));
}

void KeptTweaks::retry_waiting() {
    if (!waiting_.empty() && applied_) try_waiting(true);
}

/// The path under which the file has the values of an instance. Before the file moves it, and when
/// the game makes it again later, the instance has the path of its scene file.
std::string KeptTweaks::path_of_values(Handle instance) const {
    std::string path = tree_.path(instance);
    if (contents_.moved.empty()) return path;
    if (moved_ && (contents_.values.contains(path) || !is_marked(contents_.moves.home(path))))
        return path;
    return contents_.moves.now(path);
}

void KeptTweaks::apply_values(Handle top) {
    if ((contents_.values.empty() && waiting_.empty()) || !tree_.alive(top)) return;
    if (top != tree_.root() && !tree_.is_below(top, tree_.root())) return;
    std::vector<std::pair<Handle, const std::vector<Kept>*>> found;
    tree_.each_below(top, [&](Handle handle) {
        auto it = contents_.values.find(path_of_values(handle));
        if (it != contents_.values.end()) found.emplace_back(handle, &it->second);
    });
    for (const auto& [handle, kept] : found)
        for (const Kept& each : *kept)
            if (const Node* node = member("values", each.key); node && tree_.alive(handle))
                assign_or_wait({handle, each.property, each.key, {}, document_, node});
    try_waiting(false);
}

/// The instance that the first `count` names lead to. If it does not exist, that is reported
/// together with `then`, which says what it means for the tweak. "": no report.
Handle KeptTweaks::find(const Node& node, const std::string& path, std::size_t count,
                        const std::string& then) {
    const std::vector<Segment> segments = parse_path(path);
    Handle at = tree_.root();
    for (std::size_t i = 0; i < count && i < segments.size(); ++i) {
        const std::string& name = std::get<std::string>(segments[i].key);
        const Handle child = tree_.child(at, name);
        if (!child) {
            if (then.empty()) return {};
            if (const Property* const property = tree_.find(at, name)) {
                const std::string whole = joined_path(segments, i + 1);
                warn(document_->has_key(node) ? node.key_begin : node.begin,
                     path + ": " + whole + " is a property: write its whole value" +
                         (property->type == Type::vec2 ? ", as in \"" + whole + "\": [0, 0]" : "") +
                         "; what is here has no effect");
                return {};
            }
            std::vector<std::string> names;
            for (const Handle each : tree_.children(at)) names.push_back(tree_.name(each));
            warn(document_->has_key(node) ? node.key_begin : node.begin,
                 path + ": there is no " + joined_path(segments, i + 1) + suggestion(name, names) +
                     "; " + then);
            return {};
        }
        at = child;
    }
    return at;
}

void KeptTweaks::report_unused_values() {
    const Node* values =
        problem_.empty() && document_ ? document_->member(document_->root(), "values") : nullptr;
    if (values == nullptr) return;
    for (const Node* node = document_->first(*values); node; node = document_->next(*node)) {
        const std::string& path = document_->key(*node);
        find(*node, path, parse_path(path).size() - 1,
             "the value is set when an instance of that path is made");
    }
}

std::vector<Handle> KeptTweaks::apply_all() {
    waiting_.clear();  // they are added again
    std::vector<Handle> moved = apply_structure();
    apply_values(tree_.root());
    applied_ = true;
    compare_with_given();
    located_.reset();
    try_waiting(true);
    report_unused_values();
    run_formulas();
    return moved;
}

/// Values that modules derive from formulas must be correct before the first barrier.
void KeptTweaks::run_formulas() {
    for (const auto& [path, values] : contents_.values)
        if (const Handle instance = instance_or_none(tree_, path))
            for (const Kept& each : values)
                if (const Property* property = tree_.find(instance, each.property);
                    property != nullptr && tree_.formula(instance, *property) != nullptr)
                    try {
                        (void)tree_.get(instance, *property);
                    } catch (const Error&) {  // the error is stored in the property
                    }
}

}  // namespace fettle::property
