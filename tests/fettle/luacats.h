#pragma once
// A strict reader of LuaCATS annotations: every line must be one it knows, and every type must
// parse. It is written from the format, and knows nothing of the writer.

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace luacats {

/// A line that is no annotation, named by its number.
class Malformed : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Field {
    std::string type, doc;
};

struct Parameter {
    std::string name, type, doc;
    bool optional = false;
};

struct Function {
    std::string doc;
    std::vector<Parameter> parameters;
    std::vector<Field> returns;
    std::vector<std::string> overloads;  // types
};

struct Class {
    std::string doc, base;
    std::map<std::string, Field> fields;
    std::map<std::string, Function> methods;
    std::vector<std::string> overloads, operators;
};

struct File {
    std::map<std::string, Class> classes;
    std::map<std::string, Function> functions;  // globals, by dotted name
    std::map<std::string, Field> variables;     // globals, by dotted name
    std::set<std::string> types;                // every type that is named anywhere
};

/// Throws Malformed.
File read(const std::string& text);

}  // namespace luacats
