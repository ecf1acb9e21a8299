#include "descriptor_check.h"

#include <algorithm>
#include <map>
#include <set>

#include <fettle/property/error.h>
#include <fettle/property/native.h>
#include <fettle/property/path.h>

namespace fettle::property {
namespace {

std::string in_quotes(std::string_view name) {
    return "\"" + std::string(name) + "\"";
}

class DescriptorCheck {
  public:
    DescriptorCheck(const ClassDescriptor& descriptor, const Class* base)
        : of_(descriptor), base_(base) {}

    void run() {
        if (!of_.stem.empty() && !is_word(of_.stem))
            refuse(ErrorKind::bad_name, "stem " + in_quotes(of_.stem),
                   "expected letters, digits and underscores");
        check_number("how its rows are saved", "`snapshots`", of_.snapshots, Snapshots::never);
        for (const Property& property : of_.properties) check(property);
        for (const Method& method : of_.methods) check(method);
        for (const Event& event : of_.events) check(event);
        check_rows();
    }

  private:
    [[noreturn]] void refuse(ErrorKind kind, const std::string& member,
                             const std::string& reason) const {
        throw Error(kind, "class " + of_.name + ": " + member + ": " + reason);
    }

    // --- Rows

    /// A member that it inherits and that is called with its rows; "": there is none.
    std::string uses_rows() const {
        for (const Property* property : base_->properties())
            if (property->binding.kind == BindingKind::column ||
                property->binding.kind == BindingKind::accessor)
                return "property " + in_quotes(property->name);
        // Those of Object are not: all classes have them.
        for (const Method* method : base_->methods())
            if (method->owner->base() != nullptr) return "method " + in_quotes(method->name);
        return "";
    }

    void check_rows() const {
        if (base_ == nullptr) return;
        if (base_->snapshots() == Snapshots::natively && of_.snapshots == Snapshots::never)
            refuse(ErrorKind::bad_structure, "`snapshots`",
                   base_->name() +
                       ", from which it derives, is saved natively, with the rows of "
                       "this class: expected `natively`, or nothing");
        const Lifecycle& own = of_.lifecycle;
        const Lifecycle& of_base = base_->lifecycle();
        const bool has_own = own.any();
        const bool base_has_rows = of_base.create || of_base.place || of_base.destroy;
        if (!has_own && base_has_rows && of_.snapshots == Snapshots::natively &&
            base_->snapshots() != Snapshots::natively)
            refuse(ErrorKind::bad_structure, "`snapshots`",
                   "its rows are those of " + base_->name() +
                       ", which is not saved natively: expected nothing, or a lifecycle of its "
                       "own");
        if (!has_own || !base_has_rows || of_.makes_base_rows) return;
        const std::string user = uses_rows();
        if (user.empty()) return;
        const Class* maker = base_;
        while (maker->base() != nullptr && &maker->base()->lifecycle() == &of_base)
            maker = maker->base();
        refuse(ErrorKind::bad_structure, "`lifecycle`",
               "it inherits the " + user + " of " + base_->name() +
                   ", which uses rows that the lifecycle of " + maker->name() +
                   " makes: expected no lifecycle of its own, unless it makes such rows "
                   "(`makes_base_rows`)");
    }

    // --- Names

    /// `kind`: "property", for example. All members of a class and its bases need different names.
    void add_member_name(const char* kind, const std::string& name, bool word) {
        check_name_length(name);
        const std::string member = std::string(kind) + " " + in_quotes(name);
        if (name.empty()) refuse(ErrorKind::bad_name, member, "it has no name");
        if (word ? !is_word(name) : !is_identifier(name))
            refuse(ErrorKind::bad_name, member,
                   word ? "expected letters, digits and underscores"
                        : "expected a name as Lua has them, and no word of Lua");
        const auto [taken, first] = names_.emplace(name, kind);
        if (!first) {
            if (taken->second == std::string_view(kind))
                refuse(ErrorKind::bad_name, member, "it is declared twice");
            refuse(ErrorKind::bad_name, member,
                   "the class has " + article(taken->second) + " of that name");
        }
        if (base_ == nullptr) return;
        const auto inherits = [&](const char* what) {
            if (what != std::string_view(kind))
                refuse(ErrorKind::bad_name, member,
                       base_->name() + ", from which it derives, has " + article(what) +
                           " of that name");
        };
        if (base_->property(name) != nullptr) inherits("property");
        if (base_->method(name) != nullptr) inherits("method");
        if (base_->event(name) != nullptr) inherits("event");
    }
    static std::string article(std::string_view kind) {
        return (kind == "event" ? "an " : "a ") + std::string(kind);
    }

    void check_fields(const std::string& member, const char* what, const std::vector<Field>& fields,
                      bool may_be_one_without_name) const {
        std::set<std::string_view> seen;
        for (const Field& field : fields) {
            if (field.name.empty() && may_be_one_without_name && fields.size() == 1) continue;
            if (field.name.empty())
                refuse(ErrorKind::bad_name, member, std::string("a ") + what + " has no name");
            check_number(member, ("the type of the " + std::string(what)).c_str(), field.type,
                         Type::list);
            check_number(member, ("the element type of the " + std::string(what)).c_str(),
                         field.element, Type::list);
            if (!(field.range.min <= field.range.max))
                refuse(ErrorKind::out_of_range, member,
                       std::string("the range of the ") + what + " " + in_quotes(field.name) +
                           " begins at " + number_text(field.range.min) + " and ends at " +
                           number_text(field.range.max));
            if (!seen.insert(field.name).second)
                refuse(
                    ErrorKind::bad_name, member,
                    std::string("the ") + what + " " + in_quotes(field.name) + " is there twice");
        }
    }

    // --- Members

    void check(const Property& property) {
        add_member_name("property", property.name, true);
        const std::string member = "property " + in_quotes(property.name);
        const Property* inherited = base_ == nullptr ? nullptr : base_->property(property.name);
        // Nothing is drawn at a service, so that it may use the name `z` for something else, such
        // as a key.
        const bool instead = inherited != nullptr && inherited->sparse && !of_.creatable &&
                             property.binding.kind != BindingKind::stored;
        if (inherited != nullptr && !instead) {
            check_redeclared(member, property, *inherited);
            return;
        }
        check_type(member, property);
        check_default(member, property);
        check_range(member, property);
        check_binding(member, property);
    }

    /// Checks a property that a base class declares and this class redeclares.
    void check_redeclared(const std::string& member, const Property& again,
                          const Property& inherited) const {
        const bool other_type = again.type != inherited.type && again.type != Type::number;
        if (other_type || again.range.bounded() || !again.unit.empty() ||
            !again.enumerators.empty() || !again.derives_from.empty() ||
            !again.reference_class.empty() || again.element != Type::nil ||
            again.binding.kind != BindingKind::stored)
            refuse(ErrorKind::wrong_type, member,
                   inherited.owner->name() +
                       " declares it: a derived class may give it another default and another "
                       "text of help, and nothing else");
        if (inherited.read_only || inherited.binding.kind == BindingKind::node)
            refuse(ErrorKind::read_only, member,
                   "every " + inherited.owner->name() +
                       " has it already, as a value that has no default; use another name");
    }

    template <class Enum>
    void check_number(const std::string& member, const char* what, Enum value, Enum last) const {
        if (static_cast<unsigned>(value) > static_cast<unsigned>(last))
            refuse(ErrorKind::wrong_type, member,
                   std::string(what) + " is number " +
                       std::to_string(static_cast<unsigned>(value)) + ", expected 0 to " +
                       std::to_string(static_cast<unsigned>(last)));
    }

    void check_type(const std::string& member, const Property& property) const {
        check_number(member, "its type", property.type, Type::list);
        check_number(member, "the type of its elements", property.element, Type::list);
        const bool is_list = property.type == Type::list;
        if (!property.enumerators.empty() && property.type != Type::text)
            refuse(ErrorKind::wrong_type, member,
                   "enumerators are for a text, and it is of type " +
                       std::string(type_name(property.type)));
        std::set<std::string_view> seen;
        for (const std::string& enumerator : property.enumerators)
            if (enumerator.empty() || !seen.insert(enumerator).second)
                refuse(ErrorKind::bad_name, member,
                       "the enumerator " + in_quotes(enumerator) +
                           (enumerator.empty() ? " has no name" : " is there twice"));
        if (property.element != Type::nil && !is_list)
            refuse(ErrorKind::wrong_type, member,
                   "elements are of a list, and it is of type " +
                       std::string(type_name(property.type)));
        const bool refers = property.type == Type::reference ||
                            property.element == Type::reference || property.any_type;
        if (!property.reference_class.empty() && !refers)
            refuse(ErrorKind::wrong_type, member,
                   "a class of references is given, and it is of type " +
                       std::string(type_name(property.type)));
        if (property.type == Type::nil && !property.any_type)
            refuse(ErrorKind::wrong_type, member, "it is of no type, and does not take any");
    }

    /// A default must not refer to an instance, since a class has none. Other errors are found when
    /// the default is coerced.
    void check_default(const std::string& member, const Property& property) const {
        if (refers_to_instance(property.default_value))
            refuse(ErrorKind::wrong_type, member,
                   "its default names an instance: a reference must begin empty; a class is "
                   "declared instead, as in target = Body");
    }
    static bool refers_to_instance(const Value& value) {
        if (value.is(Type::list)) return std::ranges::any_of(value.list(), refers_to_instance);
        return value.is(Type::reference) && value.reference();
    }

    void check_range(const std::string& member, const Property& property) const {
        const Range& range = property.range;
        if (!(range.min <= range.max))
            refuse(ErrorKind::out_of_range, member,
                   "its range begins at " + number_text(range.min) + " and ends at " +
                       number_text(range.max));
        const bool numbers = property.type == Type::number || property.type == Type::integer ||
                             property.type == Type::vec2 || property.type == Type::color ||
                             property.type == Type::list || property.any_type;
        if (range.bounded() && !numbers)
            refuse(ErrorKind::out_of_range, member,
                   "a range is for numbers, and it is of type " +
                       std::string(type_name(property.type)));
    }

    void check_binding(const std::string& member, const Property& property) const {
        const Binding& binding = property.binding;
        if (property.sparse && (binding.kind != BindingKind::stored ||
                                property.type != Type::number || property.nullable))
            refuse(ErrorKind::bad_structure, member,
                   "only a number that the tree stores and that is never nil can be sparse");
        switch (binding.kind) {
            case BindingKind::stored:
                return;
            case BindingKind::column:
                return check_column(member, property);
            case BindingKind::accessor:
                if (binding.get == nullptr)
                    refuse(ErrorKind::bad_structure, member, "its accessor has no `get`");
                return;
            case BindingKind::node:
                if (binding.node_get == nullptr)
                    refuse(ErrorKind::bad_structure, member, "its binding has no `node_get`");
                return;
            case BindingKind::ad_hoc:
                break;
        }
        refuse(ErrorKind::bad_structure, member, "a class cannot declare what users add");
    }

    void check_column(const std::string& member, const Property& property) const {
        const Binding& binding = property.binding;
        check_number(member, "the native type of its column", binding.native, Native::enumeration);
        if (binding.base == nullptr)
            refuse(ErrorKind::bad_structure, member, "its column has no `base`");
        // A stride of 0 means that all rows share one value, as in a service.
        const std::size_t min_stride = binding.stride == 0 ? 0 : size_of(binding.native);
        if (binding.stride < min_stride || binding.stride > largest_stride)
            refuse(ErrorKind::bad_structure, member,
                   "its column has a stride of " + std::to_string(binding.stride) +
                       " bytes, expected " + std::to_string(size_of(binding.native)) + " to " +
                       std::to_string(largest_stride));
        if (property.type != type_of(binding.native) || property.any_type)
            refuse(ErrorKind::wrong_type, member,
                   "its column holds values of type " +
                       std::string(type_name(type_of(binding.native))) + ", and it is of type " +
                       std::string(property.any_type ? "any" : type_name(property.type)));
        if (property.nullable) refuse(ErrorKind::wrong_type, member, "a column cannot hold nil");
        if (binding.native != Native::enumeration) return;
        if (property.enumerators.empty() || property.enumerators.size() > 256)
            refuse(ErrorKind::wrong_type, member,
                   "an enumeration needs 1 to 256 enumerators, and has " +
                       std::to_string(property.enumerators.size()));
    }

    void check(const Method& method) {
        add_member_name("method", method.name, false);
        const std::string member = "method " + in_quotes(method.name);
        if (method.call == nullptr) refuse(ErrorKind::bad_structure, member, "it has no `call`");
        check_number(member, "its effect", method.effect, Effect::memory);
        if (method.required > method.parameters.size())
            refuse(ErrorKind::bad_structure, member,
                   std::to_string(method.required) + " of its " +
                       std::to_string(method.parameters.size()) + " parameters are required");
        check_fields(member, "parameter", method.parameters, false);
        check_fields(member, "field of what it returns", method.returns, true);
    }

    void check(const Event& event) {
        add_member_name("event", event.name, false);
        const std::string member = "event " + in_quotes(event.name);
        if (base_ != nullptr && base_->event(event.name) != nullptr)
            refuse(ErrorKind::bad_name, member,
                   base_->name() + ", from which it derives, has that event already");
        check_fields(member, "field", event.fields, false);
    }

    const ClassDescriptor& of_;
    const Class* base_;
    std::map<std::string, const char*, std::less<>> names_;
};

}  // namespace

bool is_word(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
               (c >= 'A' && c <= 'Z');
    });
}

void check_descriptor(const ClassDescriptor& descriptor, const Class* base) {
    DescriptorCheck(descriptor, base).run();
}

}  // namespace fettle::property
