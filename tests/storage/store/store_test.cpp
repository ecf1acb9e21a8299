// The store: values that outlive a run.

#include <catch.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>

#include <fettle/property/error.h>
#include <fettle/property/storage/store.h>

#include "temporary_folder.h"

namespace store_test {

using namespace fettle::property;
namespace fs = std::filesystem;

namespace {

struct Place : TemporaryFolder {
    fs::path file() const { return path / "player" / "store.json"; }
    std::string text() const {
        std::ifstream in(file());
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const std::string& text) const {
        fs::create_directories(file().parent_path());
        std::ofstream(file()) << text;
    }
};

Store::Entry value(Value v) {
    return {.value = std::move(v)};
}

Store::Entry table(std::map<Store::Key, Store::Entry> entries) {
    return {.content = std::make_shared<Store::Content>(Store::Content{std::move(entries)})};
}

Value at(const Store& store, const Store::Key& key, Store::Table in = Store::root) {
    const Store::Entry* const entry = store.find(in, key);
    return entry == nullptr ? Value() : entry->value;
}

Store::Table table_at(const Store& store, const Store::Key& key, Store::Table in = Store::root) {
    const Store::Entry* const entry = store.find(in, key);
    REQUIRE(entry != nullptr);
    return entry->table;
}

}  // namespace

TEST_CASE("values of a store have the same types and bits in the next run") {
    const Place place;
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Value> values = {true,
                                       std::int64_t{3},
                                       3.0,
                                       0.1,
                                       -0.0,
                                       inf,
                                       -inf,
                                       nan,
                                       std::numeric_limits<std::int64_t>::min(),
                                       "a \"text\"\nwith ü and $",
                                       "",
                                       Vec2(1, -0.5),
                                       Vec2(inf, nan),
                                       Color{0.1f, 0.2f, 1, 0.3f}};
    {
        Store store(place.file(), {});
        for (std::size_t i = 0; i < values.size(); ++i)
            store.set(Store::root, "v" + std::to_string(i), value(values[i]));
    }
    const Store again(place.file(), {});
    for (std::size_t i = 0; i < values.size(); ++i) {
        INFO(i);
        CHECK(at(again, "v" + std::to_string(i)) == values[i]);
    }
    CHECK(again.entries(Store::root).size() == values.size());
}

TEST_CASE("tables of any keys and depth are there in the next run") {
    const Place place;
    {
        Store store(place.file(), {});
        store.set(Store::root, "list", table({{1, value(10)}, {2, value(20)}}));
        store.set(Store::root, "gaps", table({{1, value(1)}, {3, value(3)}, {"x", value(4)}}));
        store.set(Store::root, "sign", table({{"$vec2", value("text")}}));
        store.set(Store::root, "empty", table({}));
        store.set(Store::root, 7, table({{"a", table({{"b", table({{"c", value(true)}})}})}}));
        store.set(table_at(store, "list"), 3, value("third"));
    }
    const Store again(place.file(), {});
    CHECK(at(again, 3, table_at(again, "list")) == Value("third"));
    CHECK(at(again, 3, table_at(again, "gaps")) == Value(3));
    CHECK(at(again, "x", table_at(again, "gaps")) == Value(4));
    CHECK(at(again, "$vec2", table_at(again, "sign")) == Value("text"));
    CHECK(again.entries(table_at(again, "empty")).empty());
    const Store::Table a = table_at(again, "a", table_at(again, 7));
    CHECK(at(again, "c", table_at(again, "b", a)) == Value(true));
}

TEST_CASE("a store of many keys is read in reasonable time") {
    constexpr int count = 200'000;
    const Place place;
    std::string values;
    for (int i = 0; i < count; ++i)
        values += (i > 0 ? ",\"k" : "\"k") + std::to_string(i) + "\":" + std::to_string(i);
    place.write("{\"fettle_store\":1,\"values\":{" + values + "}}");
    const auto begun = std::chrono::steady_clock::now();
    const Store store(place.file(), {});
    CHECK(at(store, "k199999") == Value(199'999));
    CHECK(store.entries(Store::root).size() == count);
    CHECK(std::chrono::steady_clock::now() - begun < std::chrono::seconds(5));
}

TEST_CASE("a table that was replaced is no longer in the store") {
    const Place place;
    Store store(place.file(), {});
    store.set(Store::root, "t", table({{"inner", table({})}}));
    const Store::Table old = table_at(store, "t"), inner = table_at(store, "inner", old);
    store.set(Store::root, "t", table({}));
    CHECK_FALSE(store.has(old));
    CHECK_FALSE(store.has(inner));
    CHECK_THROWS_WITH(store.set(inner, "x", value(1)), contains("no longer in the store"));
    CHECK(store.entries(table_at(store, "t")).empty());
    CHECK(store.path(table_at(store, "t"), "two words") == "store.t[\"two words\"]");
}

TEST_CASE("the content of a replaced table up to a size can be read through its userdata") {
    Store store({}, {});
    std::vector<std::shared_ptr<const Store::Content>> held;
    const std::string large(1 << 20, 'x');
    for (int i = 0; i < 40; ++i) {
        store.set(Store::root, "t", table({{"inner", table({{"x", value(large)}})}}));
        const Store::Table outer = table_at(store, "t");
        held.push_back(store.content(outer));
        held.push_back(store.content(table_at(store, "inner", outer)));
    }
    store.set(Store::root, "t", value(1));
    std::size_t bytes = 0;
    for (const auto& content : held)
        if (const auto found = content->entries.find("x"); found != content->entries.end())
            bytes += found->second.value.text().size();
    CHECK(bytes <= Store::size_limit);
    CHECK(held.front()->forgotten);
    REQUIRE_FALSE(held.back()->forgotten);
    CHECK(held.back()->entries.at("x").value.text() == large);
}

TEST_CASE("a value that a store cannot hold is refused and changes nothing") {
    const Place place;
    Store store(place.file(), {});
    store.set(Store::root, "a", value(1));
    CHECK_THROWS_WITH(store.set(Store::root, "a", value(Handle{1, 1})),
                      contains("store.a: an instance"));
    CHECK_THROWS_WITH(store.set(Store::root, "a", value("\xff")), contains("UTF-8"));
    CHECK_THROWS_WITH(store.set(Store::root, "\xff", value(1)), contains("UTF-8"));
    CHECK_THROWS_WITH(store.set(Store::root, "a", table({{"b", value(Handle{1, 1})}})),
                      contains("an instance"));
    Store::Entry deep = value(1);
    for (int i = 0; i <= Store::depth_limit; ++i) deep = table({{"x", deep}});
    CHECK_THROWS_WITH(store.set(Store::root, "a", deep), contains("nested"));
    const std::string large(Store::size_limit, 'x');
    CHECK_THROWS_WITH(store.set(Store::root, "b", value(large)), contains("16 MiB"));
    CHECK(at(store, "a") == Value(1));
    CHECK(store.entries(Store::root).size() == 1);
    store.set(Store::root, "b", value(std::string(Store::size_limit - 1000, 'x')));
    store.set(Store::root, "b", value(2));
    store.set(Store::root, "c", value(std::string(Store::size_limit - 1000, 'x')));
}

TEST_CASE("two processes keep each other's keys") {
    const Place place;
    Store one(place.file(), {}), other(place.file(), {});
    one.set(Store::root, "one", value(1));
    one.set(Store::root, "both", value("one"));
    other.set(Store::root, "other", table({{1, value(2)}}));
    other.set(Store::root, "both", value("other"));
    one.flush();
    other.flush();
    const Store after(place.file(), {});
    CHECK(at(after, "one") == Value(1));
    CHECK(at(after, 1, table_at(after, "other")) == Value(2));
    CHECK(at(after, "both") == Value("other"));
    // A run sees its own values only.
    CHECK(at(one, "both") == Value("one"));
}

TEST_CASE("clear also removes values that another process has written") {
    const Place place;
    Store one(place.file(), {}), other(place.file(), {});
    one.set(Store::root, "old", table({}));
    const Store::Table old = table_at(one, "old");
    one.clear();
    one.set(Store::root, "new", value(1));
    other.set(Store::root, "other", value(2));
    other.flush();
    one.flush();
    CHECK_FALSE(one.has(old));
    const Store after(place.file(), {});
    CHECK(after.entries(Store::root).size() == 1);
    CHECK(at(after, "new") == Value(1));
}

TEST_CASE("a value that is assigned again and again is written once it is old enough") {
    const Place place;
    Store store(place.file(), {});
    for (int i = 0; i < 1000; ++i) {
        store.set(Store::root, "n", value(i));
        store.tick();
    }
    store.flush();
    const Store after(place.file(), {});
    CHECK(at(after, "n") == Value(999));
}

TEST_CASE("a damaged file is reported and kept beside the new one") {
    const auto text = GENERATE(as<std::string>(), "{ \"fettle_store\": 1, \"values\": {", "[]", "",
                               R"({"fettle_store": 2, "values": {}})",
                               R"({"fettle_store": 1, "values": {"a": null}})",
                               R"({"fettle_store": 1, "values": {"a": {"$vec2": [1]}}})",
                               R"({"fettle_store": 1, "values": {"a": {"$what": 1}}})",
                               R"({"fettle_store": 1, "values": 5})");
    INFO(text);
    const Place place;
    place.write(text);
    std::string warnings;
    {
        Store store(place.file(),
                    {.warn = [&](const std::string& warning) { warnings += warning; }});
        CHECK(store.entries(Store::root).empty());
        CHECK(warnings.empty() == text.empty());
        store.set(Store::root, "a", value(1));
    }
    CHECK(at(Store(place.file(), {}), "a") == Value(1));
    std::ifstream aside(place.file().parent_path() / "store.damaged-1.json");
    CHECK(std::string{std::istreambuf_iterator<char>(aside), {}} == text);
    CHECK(aside.is_open());
}

TEST_CASE(
    "a store without a file warns once that its values end with the run unless that was "
    "requested") {
    const bool wanted = GENERATE(false, true);
    std::vector<std::string> warnings;
    Store store("", {.writes = !wanted,
                     .warn = [&](const std::string& warning) { warnings.push_back(warning); }});
    CHECK(warnings.empty());
    store.set(Store::root, "a", value(1));
    store.set(Store::root, "b", value(2));
    store.tick();
    store.flush();
    CHECK(warnings == (wanted ? std::vector<std::string>()
                              : std::vector<std::string>{"the store of the game ends with the run: "
                                                         "there is no folder for it"}));
    CHECK(at(store, "b") == Value(2));
}

TEST_CASE("a store that cannot be written is reported and written later") {
    const Place place;
    std::ofstream(place.path / "player") << "a file in the place of the folder";
    std::string warnings;
    Store store(place.file(), {.warn = [&](const std::string& warning) { warnings += warning; }});
    store.set(Store::root, "a", value(1));
    store.flush();
    CHECK_THAT(warnings, contains("the store of the game was not written"));
    Store named(place.file(), {.warn = [&](const std::string& warning) { warnings = warning; },
                               .name = "the list"});
    named.set(Store::root, "a", value(1));
    named.flush();
    CHECK_THAT(warnings, contains("the list was not written"));
    fs::remove(place.path / "player");
    store.flush();
    CHECK(at(Store(place.file(), {}), "a") == Value(1));
}

TEST_CASE("a store of a replay begins with the recorded text and writes nothing") {
    const Place place;
    {
        Store first(place.file(), {});
        first.set(Store::root, "best", value(5));
    }
    const std::string text = place.text();
    {
        Store replay(place.file(), {.content = "", .writes = false});
        CHECK(replay.entries(Store::root).empty());
        replay.set(Store::root, "best", value(6));
        replay.clear();
    }
    CHECK(place.text() == text);
    CHECK(at(Store("", {.content = text, .writes = false}), "best") == Value(5));
}

}  // namespace store_test
