#pragma once
// Descriptions of the language besides classes: global functions, callbacks, kinds of values. Help,
// completion, editor annotations and the reference are made from them.
//
// A signature has the form of LuaCATS annotations; several signatures are separated by line ends:
//   "after(seconds: number, action: fun()): Connection"
//   "color(name: string): color\ncolor(r: number, g: number, b: number, a?: number): color"

#include <string>
#include <string_view>
#include <vector>

namespace fettle::script {

struct GlobalDoc {
    const char* name;  // "after", "scene.load"
    const char* signature;
    const char* doc;
};

/// Functions of Fettle, sorted by name.
const std::vector<GlobalDoc>& global_docs();
/// Functions of Lua's own library that scripts may use, sorted by name.
const std::vector<GlobalDoc>& library_docs();
/// Globals that are not functions: `game`, `classes`, `it` ...; the signature is the type.
const std::vector<GlobalDoc>& variable_docs();
/// Functions of a game that the host calls, in the order in which a game needs them.
const std::vector<GlobalDoc>& callback_docs();
const std::vector<std::string>& callback_names();
/// Functions of a class made with class(...) that the host calls.
const std::vector<GlobalDoc>& class_callback_docs();
/// Methods that every instance has, sorted by name.
const std::vector<GlobalDoc>& instance_docs();
const std::vector<std::string>& generic_names();
/// A global of any of these kinds; nullptr if there is none.
const GlobalDoc* global_doc(std::string_view name);

/// The entry as shown in lists: a function without types, a variable by its name.
std::string shown_name(const GlobalDoc& doc);

/// A member of a value: `vec.x`, `connection:stop()`. For a field, the signature is its type.
struct MemberDoc {
    const char* name;
    const char* signature;
    const char* doc;
    bool is_function() const;
};

/// A kind of value that is not a class of the tree.
struct TypeDoc {
    const char* name;
    const char* doc;
    std::vector<MemberDoc> members;
    std::vector<const char*> operators{};  // "add(vec): vec"
    bool by_dot = false;                   // functions are called with a dot: pen.circle(...)
};

const std::vector<TypeDoc>& type_docs();
const TypeDoc* type_doc(std::string_view name);

}  // namespace fettle::script
