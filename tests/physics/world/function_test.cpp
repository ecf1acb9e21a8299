// Functions that a world keeps.

#include <catch.h>
#include <fettle/physics/function.h>

#include <array>
#include <functional>
#include <memory>
#include <stdexcept>

namespace function_test {

using fettle::physics::Function;

namespace {

int twice(int x) {
    return 2 * x;
}

/// Counts its copies that live.
struct Counted {
    explicit Counted(int& count) : living(&count) { ++*living; }
    Counted(const Counted& other) : living(other.living) { ++*living; }
    Counted& operator=(const Counted&) = delete;
    ~Counted() { --*living; }
    int operator()(int x) const { return x + *living; }
    int* living;
};

}  // namespace

TEST_CASE("a Function is made of a lambda or a pointer or a std::function") {
    int offset = 3;
    Function<int(int)> function = [&](int x) { return x + offset; };
    CHECK(function(4) == 7);
    offset = 5;
    CHECK(function(4) == 9);
    function = twice;
    CHECK(function(4) == 8);
    function = std::function<int(int)>(twice);
    CHECK(function(5) == 10);
    std::array<int, 20> many{};
    many[19] = 6;
    function = [many](int x) { return x + many[19]; };
    const Function<int(int)> copy = function;
    function = nullptr;
    CHECK(copy(1) == 7);
    const std::function<int(int)> back = copy;
    CHECK(back(2) == 8);
}

TEST_CASE("an empty Function refuses a call") {
    const Function<int(int)> none;
    CHECK_FALSE(none);
    CHECK(none == nullptr);
    CHECK_THROWS_AS(none(1), std::logic_error);
    CHECK_FALSE(Function<int(int)>(std::function<int(int)>()));
    int (*const null)(int) = nullptr;
    CHECK_FALSE(Function<int(int)>(null));
    CHECK_FALSE(Function<int(int)>(nullptr));
    CHECK(Function<int(int)>(twice));
}

TEST_CASE("a Function destroys every copy of its callable") {
    int living = 0;
    {
        Function<int(int)> one = Counted(living);
        CHECK(living == 1);
        Function<int(int)> two = one;
        CHECK(living == 2);
        const Function<int(int)>& itself = two;
        two = itself;
        CHECK(two(40) == 42);
        Function<int(int)> three = std::move(one);
        CHECK(living == 2);
        CHECK_FALSE(one);
        two = three;
        three = nullptr;
        CHECK(living == 1);
        CHECK(two(1) == 2);
    }
    CHECK(living == 0);
}

TEST_CASE("a Function passes on arguments and results") {
    int count = 0;
    Function<void(int&)> changes = [count](int& x) mutable { return x = ++count; };
    int x = 0;
    changes(x);
    changes(x);
    CHECK(x == 2);
    const Function<std::unique_ptr<int>(std::unique_ptr<int>)> moves =
        [](std::unique_ptr<int> value) { return value; };
    CHECK(*moves(std::make_unique<int>(3)) == 3);
}

}  // namespace function_test
