// Mistakes in what a module declares and gives back: each is refused, with the member and the
// value.

#include <catch.h>

#include <cstdlib>
#include <string>

#include <fettle/property/error.h>
#include <fettle/property/reserved_names.h>

#include "weather.h"

namespace untidy_test {

using namespace fettle;
using namespace fettle::module::testing;
using property::Handle;
using property::Value;

namespace {

class Mistake {
  public:
    explicit Mistake(const std::string& which) { setenv(name, which.c_str(), 1); }
    ~Mistake() { unsetenv(name); }
    Mistake(const Mistake&) = delete;

  private:
    static constexpr const char* name = "FETTLE_TEST_UNTIDY";
};

}  // namespace

TEST_CASE("a mistake in the description of a class is refused with the member and the value") {
    const auto [mistake, message] = GENERATE(table<std::string, std::string>({
        {"range", "class Untidy: property \"value\": its range begins at 9 and ends at 5"},
        {"flags", "Untidy.value: expected `flags` of at most 511, got 4294967295"},
        {"class flags", "Untidy: expected `flags` of at most 3, got 12"},
        {"binding", "Untidy.value: there is no binding number 9, expected 0 to 2"},
        {"doc", "Untidy.value: its `doc` is not UTF-8 from byte 3 on"},
        {"class doc", "Untidy: its `doc` is not UTF-8 from byte 2 on"},
        {"size", "a class descriptor: expected a struct_size of at least "},
        {"parameter", "the range of the parameter \"weight\" begins at 3 and ends at 2"},
    }));
    const Mistake made(mistake);
    CHECK_THAT(refusal(built("untidy")), contains(message));
}

TEST_CASE("a member of a class cannot hide a method of every instance") {
    const auto [mistake, message] = GENERATE(table<std::string, std::string>({
        {"property name", "Untidy.children: is a method of every instance"},
        {"method name", "Untidy.add: is a method of every instance"},
    }));
    const Mistake made(mistake);
    module::Plugins plugins;
    module::Plugin& untidy = plugins.open(built("untidy"));
    property::Tree tree;
    const bool before = GENERATE(true, false);
    if (before) {
        property::reserve_names(tree, {"children", "add"});
        CHECK_THROWS_WITH(untidy.attach(tree), contains(message));
    } else {
        untidy.attach(tree);
        CHECK_THROWS_WITH(property::reserve_names(tree, {"children", "add"}), contains(message));
    }
}

TEST_CASE("values that a module may not give are refused with the member") {
    const auto [mistake, message] = GENERATE(table<std::string, std::string>({
        {"nan result", "one:answer(): the module gave nan"},
        {"nil result", "one:answer(): the module gave nil, expected a number"},
        {"text result", "one:answer(): the module gave \"much\", expected a number"},
        {"none", ""},
    }));
    const Mistake made(mistake);
    module::Plugins plugins;
    property::Tree tree;
    plugins.open(built("untidy")).attach(tree);
    const Handle one = tree.create(tree.class_named("Untidy"), tree.root(), "one");
    std::string error;
    try {
        const Value read = tree.get(one, "value");
        CHECK(read == Value(1.5));
        const property::Result answer = tree.call(one, "answer", {});
        CHECK(std::get<Value>(answer) == Value(2.5));
    } catch (const property::Error& refused) {
        error = refused.what();
    }
    CHECK_THAT(error, contains(message));
    CHECK(error.empty() == message.empty());
}

TEST_CASE("a getter that gives NaN or infinity is read as the default") {
    const Mistake made(GENERATE("nan getter", "inf getter"));
    module::Plugins plugins;
    property::Tree tree;
    plugins.open(built("untidy")).attach(tree);
    const Handle one = tree.create(tree.class_named("Untidy"), tree.root(), "one");
    CHECK(tree.get(one, "value") == Value(1.0));
}

}  // namespace untidy_test
