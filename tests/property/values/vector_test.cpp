#include <fettle/property/value.h>
#include <fettle/vector/convert.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "catch.h"

namespace vector_test {
namespace {

using fettle::Vector2;

/// As SFML and raylib have it.
struct Point {
    float x, y;
};

/// As Eigen has it.
class Functions {
  public:
    double x() const { return x_; }
    double y() const { return y_; }
    double& x() { return x_; }
    double& y() { return y_; }

  private:
    double x_ = 0, y_ = 0;
};

TEST_CASE("vectors are added and scaled and compared by their components") {
    Vector2<double> v(1, 2);
    v += {3, 4};
    CHECK(v == Vector2<double>(4, 6));
    v -= {1, 1};
    v *= 2;
    v /= 4;
    CHECK(v == Vector2<double>(1.5, 2.5));
    CHECK(2 * v - v * 2 == Vector2<double>());
    CHECK(-v / 2 == Vector2<double>(-0.75, -1.25));
    CHECK(v[0] == 1.5);
    CHECK(v[1] == 2.5);
}

TEST_CASE("length and products of vectors follow their equations") {
    const Vector2<float> a(3, 4), b(-4, 3);
    CHECK(a.length() == 5);
    CHECK(a.length_squared() == 25);
    CHECK(a.dot(b) == 0);
    CHECK(a.cross(b) == 25);  // b lies counter-clockwise of a
    CHECK((a.normalized() - Vector2<float>(0.6, 0.8)).length() < 1e-6f);
    CHECK(Vector2<float>().normalized() == Vector2<float>());
    CHECK(a.times(b) == Vector2<float>(-12, 12));
    CHECK(a.over({2, 8}) == Vector2<float>(1.5, 0.5));
}

TEST_CASE("the smaller and larger components of two vectors make a box") {
    const Vector2<double> a(1, -2), b(0, 5);
    CHECK(a.min(b) == Vector2<double>(0, -2));
    CHECK(a.max(b) == Vector2<double>(1, 5));
    CHECK(a.abs() == Vector2<double>(1, 2));
    CHECK(a.smallest() == -2);
    CHECK(b.largest() == 5);
    CHECK(Vector2<double>(0.5, 0).within(a.min(b), a.max(b)));
    CHECK_FALSE(Vector2<double>(0.5, 6).within(a.min(b), a.max(b)));
}

TEST_CASE("a vector with an infinite component or with no number is not finite") {
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(Vector2<double>(1e300, -1e300).is_finite());
    CHECK_FALSE(Vector2<double>(inf, 0).is_finite());
    CHECK_FALSE(Vector2<double>(0, std::nan("")).is_finite());
}

TEST_CASE("vectors of other libraries are converted both ways") {
    const Vector2<double> v(1.25, -2.5);
    const Point point = fettle::to<Point>(v);
    CHECK(point.x == 1.25f);
    CHECK(point.y == -2.5f);
    const auto functions = fettle::to<Functions>(v);
    CHECK(functions.x() == 1.25);
    CHECK(functions.y() == -2.5);
    CHECK(fettle::from<Vector2<double>>(point) == v);
    CHECK(fettle::from<Vector2<double>>(functions) == v);
}

TEST_CASE("the vectors of tree and physics are converted by name only") {
    using Small = Vector2<float>;
    using Large = fettle::property::Vec2;
    STATIC_REQUIRE_FALSE(std::is_convertible_v<Large, Small>);
    CHECK(Small(Large(0.1, 0.2)).x == 0.1f);
    CHECK(Large(Small(0.5, 0.25)) == Large(0.5, 0.25));
    STATIC_REQUIRE(std::is_trivially_copyable_v<Small>);
}

}  // namespace
}  // namespace vector_test
