#pragma once
// The reference of everything that a game can use, from the class descriptors of a tree and the
// descriptions of the language: annotations for editors, pages for readers, and one line for a
// property. All of it is generated.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::script {

/// One file of LuaCATS annotations (`---@meta`) for lua-language-server. All modules and services
/// must be attached to `tree`; the children of its root are globals.
std::string annotations(const property::Tree& tree);

/// The descriptor in one line: "number · kg · 0 to inf · default 1 · read-only".
std::string property_facts(const property::Tree& tree, const property::Property& property);

/// Documentation as a terminal and the console show it: without the marks of code that the pages
/// have.
std::string shown_doc(std::string_view doc);

struct ReferencePage {
    std::string file;  // "README.md", "classes/Body.md"
    std::string text;  // Markdown
};

/// An index, one page for each class, and pages of functions, callbacks and values.
std::vector<ReferencePage> reference_pages(const property::Tree& tree);

}  // namespace fettle::script

FETTLE_SCRIPT_END
