// Calls of methods. Arguments are coerced in the same way as values of properties.

#include <stdexcept>

#include <fettle/property/exception_text.h>
#include <fettle/property/literal_hint.h>
#include <fettle/property/spelling.h>

#include <classes/coerce.h>

#include "state.h"

namespace fettle::property {

namespace {

/// Reports a call that changes a module's memory to observers, also if it ends with an exception.
class CallScope {
  public:
    CallScope(Tree::State& state, Handle self, const Method& method, std::span<const Value> given)
        : state_(state), self_(self), method_(method) {
        if (is_observed())
            state_.changes.notify([&](Observer& o) { o.call_begins(self_, method_, given); });
    }
    ~CallScope() {
        if (is_observed() && !state_.lifetime.ending)
            state_.changes.notify([&](Observer& o) { o.call_ends(self_, method_); });
    }
    CallScope(const CallScope&) = delete;

  private:
    bool is_observed() const {
        return method_.effect == Effect::memory && !state_.changes.observers.all.empty();
    }
    Tree::State& state_;
    Handle self_;
    const Method& method_;
};

/// Two numbers in the place of a vector are reported as such, whatever number of arguments results.
void refuse_loose_components(const Method& method, std::span<const Value> arguments,
                             const auto& call) {
    for (std::size_t i = 0; i < method.parameters.size() && i + 1 < arguments.size(); ++i) {
        const Value &x = arguments[i], &y = arguments[i + 1];
        const Field& parameter = method.parameters[i];
        if (parameter.type != Type::vec2 || !x.is_numeric() || !y.is_numeric()) continue;
        throw Error(ErrorKind::wrong_type, call() + ": argument \"" + parameter.name +
                                               "\": expected a vec2, got " + value_text(x) + ", " +
                                               value_text(y) +
                                               literal_hint(Type::vec2, List{x, y}));
    }
}

}  // namespace

namespace {

/// " (position, radius, impulse?)": a question mark stands after what may be missing.
std::string names_of(const Method& method) {
    std::string text;
    for (std::size_t i = 0; i < method.parameters.size(); ++i)
        text +=
            (i == 0 ? " (" : ", ") + method.parameters[i].name + (i < method.required ? "" : "?");
    return text.empty() ? text : text + ")";
}

}  // namespace

Result Tree::call(Handle instance, const Method& method, std::span<const Value> arguments) {
    State& s = *state_;
    s.instances.require_method(instance, method);
    if (method.effect != Effect::nothing && !changeable())
        s.require_changeable("call " + method.name);
    const Use use(s.lifetime);
    const auto where = [&] { return path(instance) + ":" + method.name + "()"; };
    refuse_loose_components(method, arguments, where);
    if (arguments.size() < method.required || arguments.size() > method.parameters.size())
        throw Error(ErrorKind::wrong_type,
                    where() + ": expected " + std::to_string(method.required) +
                        (method.required == method.parameters.size()
                             ? ""
                             : " to " + std::to_string(method.parameters.size())) +
                        (method.parameters.size() == 1 && method.required == 1 ? " argument"
                                                                               : " arguments") +
                        ", got " + std::to_string(arguments.size()) + names_of(method));
    std::vector<Value> coerced(method.parameters.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const Field& parameter = method.parameters[i];
        Property as = property_like(parameter);
        as.nullable = i >= method.required;
        struct Argument {
            std::string call, name;
        } argument{where(), parameter.name};
        const auto name = [](const void* what) {
            const auto& a = *static_cast<const Argument*>(what);
            return a.call + ": argument \"" + a.name + "\"";
        };
        coerced[i] =
            coerce_value(as, arguments[i], {.tree = this, .path = name, .what = &argument});
    }
    Result result;
    {
        const CallScope scope(s, instance, method, coerced);
        try {
            result = method.call(method.context, *this, instance, row(instance), coerced);
        } catch (const std::invalid_argument& refusal) {
            if (s.lifetime.ending) throw;
            throw Error(ErrorKind::rejected, where() + ": " + refusal.what());
        } catch (const std::exception&) {
            throw;
        } catch (...) {
            if (s.lifetime.ending) throw;
            throw Error(ErrorKind::rejected, where() + ": " + exception_text());
        }
    }
    use.finish();
    return result;
}

Result Tree::call(Handle instance, std::string_view method,
                  std::initializer_list<Value> arguments) {
    const Class& of = class_of(instance);
    if (const Method* found = of.method(method))
        return call(instance, *found, std::span(arguments.begin(), arguments.size()));
    std::vector<std::string> names;
    for (const Method* m : of.methods()) names.push_back(m->name);
    throw Error(ErrorKind::unknown_name, path(instance) + " has no method \"" +
                                             std::string(method) + "\"" +
                                             suggestion(method, names));
}

}  // namespace fettle::property
