// Reload of a module while the game runs.
//
// The tree does not change: classes, instances, handles, watchers and formulas stay. The values in
// the old module's memory are copied by name, through the old getters and the new setters, so the
// memory layouts may differ. The reload is first tried in another process, and done here only if
// that succeeded.

#include "reload.h"

#include <algorithm>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include "plugin_state.h"
#include "trial/trial.h"

namespace fettle::module {
namespace {

using property::Handle;
using property::Property;
using property::Tree;
using property::Value;

struct Saved {
    Handle instance;
    BridgedClass* owner = nullptr;  // the class of its row
    bool revived = false;
    std::vector<std::pair<const Property*, Value>> values;
};

/// Writes a value without reporting a change: for the tree, the value stays the same.
void write_back(const Property& property, property::Row row, const Value& value) {
    const property::Binding& binding = property.binding;
    binding.set(binding.context, row, value);
    if (binding.invalidate != nullptr) binding.invalidate(binding.context, row);
}

/// One reload, from the old module to the new one.
class Reload {
  public:
    Reload(Plugin::State& state, const std::filesystem::path& copy)
        : s_(state), copy_(copy), tree_(*state.host.tree) {}

    Reloaded run(const std::function<void(std::string_view)>& now) {
        now(while_opened);
        OpenModule fresh = s_.open_file(copy_);
        if (view(fresh.native.name) != s_.name)
            throw LoadError(s_.file, "expected the module " + s_.name + ", found one called " +
                                         fresh.native.name);
        save();
        try {
            change_to(fresh, now);
        } catch (...) {
            s_.abandon();
            throw;
        }
        return std::move(report_);
    }

  private:
    /// Ends the old module and destroys its rows. After that, the reload cannot be undone.
    void change_to(OpenModule& fresh, const std::function<void(std::string_view)>& now) {
        for (auto saved = saved_.rbegin(); saved != saved_.rend(); ++saved)
            saved->owner->retire(saved->instance);
        s_.close_native();
        std::swap(s_.open, fresh);  // `fresh` unloads the old module when it ends
        now(while_attached);
        attach();
        for (Saved& saved : saved_)
            if (!saved.revived) revive(saved);
        s_.host.adopt = nullptr;
        restore_values();
        now(in_its_test);
        s_.check_native();
        s_.version = text_or_empty(s_.open.native.version);
        s_.identity = identity(s_.file);
    }

    BridgedClass* owner_of(Handle instance) const {
        for (const auto& c : s_.classes)
            if (c->instances().contains({instance.index, instance.generation})) return c.get();
        return nullptr;
    }

    /// Saves parents before children, in the order of the tree; then instances without a parent.
    void save() {
        const auto note = [&](Handle instance) {
            if (BridgedClass* owner = owner_of(instance)) save(instance, *owner);
        };
        tree_.each_below(tree_.root(), note);
        std::vector<Handle> tops;
        for (const auto& c : s_.classes)
            for (const auto& [index, generation] : c->instances()) {
                Handle top{index, generation};
                while (tree_.parent(top)) top = tree_.parent(top);
                if (top != tree_.root() && std::find(tops.begin(), tops.end(), top) == tops.end())
                    tops.push_back(top);
            }
        for (const Handle top : tops) {
            note(top);
            tree_.each_below(top, [&](Handle instance) {
                if (instance != top) note(instance);
            });
        }
    }

    void save(Handle instance, BridgedClass& owner) {
        Saved& saved = saved_.emplace_back();
        saved.instance = instance;
        saved.owner = &owner;
        for (const Property* property : tree_.class_of(instance).properties()) {
            const bool ours = std::any_of(s_.classes.begin(), s_.classes.end(), [&](const auto& c) {
                return c->find(*property) != nullptr;
            });
            if (!ours || property->read_only) continue;
            // Values that are not overridden are computed again by the module.
            if (property->binding.overridden && !tree_.overridden(instance, *property)) continue;
            saved.values.emplace_back(property, tree_.peek(instance, *property));
        }
    }

    void attach() {
        std::vector<const BridgedClass*> seen;
        s_.host.define_class = [&](const fettle_class& native) {
            for (const auto& c : s_.classes)
                if (c->declared().name() == view(native.name)) {
                    c->replace(native, report_.notes);
                    seen.push_back(c.get());
                    return;
                }
            s_.classes.push_back(std::make_unique<BridgedClass>(s_.host, native));
            seen.push_back(s_.classes.back().get());
        };
        // Instances that the module creates in `attach`, or with another, exist already.
        s_.host.adopt = [&](const property::Class& of, Handle parent, const char* name) {
            const Handle child = parent ? tree_.child(parent, name) : Handle{};
            if (!child || &tree_.class_of(child) != &of) return Handle{};
            for (Saved& saved : saved_)
                if (saved.instance == child && !saved.revived) revive(saved);
            return child;
        };
        s_.host.unknown = [&](const property::Class& of) {
            return std::any_of(s_.classes.begin(), s_.classes.end(), [&](const auto& c) {
                return of.is_a(c->declared()) &&
                       std::find(seen.begin(), seen.end(), c.get()) == seen.end();
            });
        };
        s_.attach_native();
        s_.host.unknown = nullptr;
        for (const auto& c : s_.classes)
            if (std::find(seen.begin(), seen.end(), c.get()) == seen.end())
                throw std::runtime_error(
                    "class " + c->declared().name() +
                    " is missing in the new module: that needs a new start of the game");
    }

    void revive(Saved& saved) {
        saved.revived = true;
        saved.owner->revive(saved.instance);
        ++report_.instances;
    }

    /// Some values may be refused until others are set, so refused values are tried a second time.
    void restore_values() {
        for (const bool last : {false, true})
            for (Saved& saved : saved_)
                std::erase_if(saved.values, [&](const auto& pair) {
                    return restore_values(saved.instance, *pair.first, pair.second, last);
                });
    }

    bool restore_values(Handle instance, const Property& property, const Value& value, bool last) {
        try {
            if (!(tree_.peek(instance, property) == value))
                write_back(property, tree_.row(instance), value);
            ++report_.values;
            return true;
        } catch (...) {
            if (last)
                report_.notes.push_back(tree_.path(instance, property) + " = " + tree_.text(value) +
                                        " was refused: " + property::exception_text());
            return false;
        }
    }

    Plugin::State& s_;
    const std::filesystem::path& copy_;
    Tree& tree_;
    std::vector<Saved> saved_;
    Reloaded report_;
};

}  // namespace

Reloaded reload(Plugin::State& state, const std::filesystem::path& copy,
                const std::function<void(std::string_view)>& now) {
    return Reload(state, copy).run(now);
}

Reloaded Plugin::reload() {
    State& s = *state_;
    if (s.host.tree == nullptr) throw std::logic_error(s.name + " is attached to no tree");
    if (s.tree_life.expired())
        throw std::logic_error(s.name + " cannot be reloaded: its tree has ended");
    if (s.host.called())
        throw std::logic_error(s.name + " cannot be reloaded while one of its functions runs");
    const ModuleCopy copy(s.file);
    std::vector<const BridgedClass*> classes;
    for (const auto& c : s.classes) classes.push_back(c.get());
    const std::string problem = run_trial({.kind = TrialKind::reload,
                                           .file = s.file,
                                           .copy = copy.path(),
                                           .name = s.name,
                                           .tree = described(*s.host.tree, classes)});
    if (!problem.empty())
        throw problem.starts_with(s.file.string())
            ? LoadError(problem)
            : LoadError(s.file, "module " + s.name + ", reloaded: " + problem);
    try {
        return module::reload(s, copy.path(), [](std::string_view) {});
    } catch (const LoadError&) {
        throw;
    } catch (...) {  // an error that did not occur in the trial
        throw LoadError(s.file,
                        "module " + s.name + ", reloaded: " + property::exception_text() +
                            (s.open.native.attach == nullptr ? "; it is not loaded any more" : ""));
    }
}

}  // namespace fettle::module
