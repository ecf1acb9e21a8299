#pragma once
// A strict reader of LuaCATS annotations: it refuses every unknown line and every invalid type. It
// is written from the description of the format, independently of the writer.

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace luacats {

/// The error for an invalid line, with its number.
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
    std::set<std::string> types;                // every type that is used
};

/// Throws Malformed.
File read(const std::string& text);

}  // namespace luacats
