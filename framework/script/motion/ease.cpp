#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <motion/ease.h>

namespace fettle::script {

namespace {

using Curve = double (*)(double);

template <int exponent>
double power(double t) {
    double product = t;
    for (int i = 1; i < exponent; ++i) product *= t;
    return product;
}

double sine(double t) {
    return 1 - std::cos(t * std::numbers::pi / 2);
}

/// From 2^-10 to 1, shifted and scaled so that it starts at 0.
double exponential(double t) {
    constexpr double start = 1.0 / 1024;
    return (std::exp2(10 * (t - 1)) - start) / (1 - start);
}

double circle(double t) {
    return 1 - std::sqrt(std::max(0.0, 1 - t * t));
}

/// Goes back by a tenth of the way first.
double back(double t) {
    constexpr double overshoot = 1.70158;
    return t * t * ((overshoot + 1) * t - overshoot);
}

/// Three and a third swings that grow.
double elastic(double t) {
    constexpr double period = 0.3;
    if (t <= 0 || t >= 1) return t;
    return -std::exp2(10 * (t - 1)) *
           std::sin((t - 1 - period / 4) * 2 * std::numbers::pi / period);
}

/// A ball dropped from 1 that bounces to 1/4, 1/16 and 1/64 of its height, seen backwards. Each
/// bounce is a parabola; with t counted in parts of 2.75, the landings are at 1, 2 and 2.5.
double bounce(double t) {
    constexpr double total = 2.75;
    const double since = (1 - t) * total;
    const auto arc = [since](double middle, double height, double half) {
        const double x = (since - middle) / half;
        return height * (1 - x * x);
    };
    if (since < 1) return 1 - since * since;
    if (since < 2) return arc(1.5, 1.0 / 4, 0.5);
    if (since < 2.5) return arc(2.25, 1.0 / 16, 0.25);
    return arc(2.625, 1.0 / 64, 0.125);
}

struct Family {
    const char* name;
    Curve in;
};

constexpr std::array<Family, 10> families{{{"quad", power<2>},
                                           {"cubic", power<3>},
                                           {"quart", power<4>},
                                           {"quint", power<5>},
                                           {"sine", sine},
                                           {"expo", exponential},
                                           {"circ", circle},
                                           {"back", back},
                                           {"elastic", elastic},
                                           {"bounce", bounce}}};

double in_out(Curve in, double t) {
    return t < 0.5 ? in(2 * t) / 2 : 1 - in(2 - 2 * t) / 2;
}

/// Cuts `start` off the name if it begins so.
bool cut_start(std::string_view& name, std::string_view start) {
    if (!name.starts_with(start)) return false;
    name.remove_prefix(start.size());
    return true;
}

}  // namespace

const std::vector<std::string>& ease_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"linear"};
        for (const Family& family : families)
            for (const char* start : {"out_", "in_", "in_out_"})
                all.push_back(std::string(start) + family.name);
        return all;
    }();
    return names;
}

double ease(std::string_view name, double time) {
    if (time <= 0 || time >= 1) return std::clamp(time, 0.0, 1.0);
    const bool both = cut_start(name, "in_out_");
    const bool out = !both && cut_start(name, "out_");
    if (!both && !out) cut_start(name, "in_");
    for (const Family& family : families) {
        if (name != family.name) continue;
        return both ? in_out(family.in, time) : out ? 1 - family.in(1 - time) : family.in(time);
    }
    return time;
}

double ease(const property::List& curve, double time) {
    if (curve.size() < 2) return time;
    const double place = std::clamp(time, 0.0, 1.0) * static_cast<double>(curve.size() - 1);
    const std::size_t before = std::min(static_cast<std::size_t>(place), curve.size() - 2);
    const double part = place - static_cast<double>(before);
    return curve[before].as_double() * (1 - part) + curve[before + 1].as_double() * part;
}

}  // namespace fettle::script
