#pragma once
// A tree with a small module, a runtime, and the output of both: the script library is tested
// without physics and without a window.

#include <memory>
#include <string>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

#include "catch.h"

namespace stage {

using fettle::property::Color;
using fettle::property::Handle;
using fettle::property::Row;
using fettle::property::Tree;
using fettle::property::Value;
using fettle::property::Vec2;
using fettle::script::Evaluation;
using fettle::script::ScriptError;

/// Memory of the module: columns of bodies, and polygons behind accessors.
struct Module {
    struct Body {
        double position[2] = {0, 0};
        float velocity[2] = {0, 0};
        float friction = 0.6f;
        std::uint8_t type = 2;
        bool awake = true;
        std::int64_t serial = 0;
        double mass = 1;
        Color color{1, 1, 1, 1};
        int wakes = 0;
    };
    struct Polygon {
        std::vector<Vec2> vertices = {{0, 0}, {1, 0}, {0, 1}};
        int rebuilds = 0;
    };
    std::vector<Body> bodies;
    std::vector<Polygon> polygons;

    void attach(Tree& tree);
};

/// Options without a time limit for calls: a machine may be slow, and a sanitizer makes it slower.
inline fettle::script::Options unhurried() {
    fettle::script::Options options;
    options.call_seconds = 0;
    return options;
}

class Stage {
  public:
    explicit Stage(fettle::script::Options options = unhurried());
    ~Stage();

    /// Runs a chunk as the game; the test fails if it raises.
    void run(const std::string& chunk);
    /// Runs a chunk that must raise; returns the message.
    std::string fails(const std::string& chunk);
    /// The printed lines of a chunk, joined with '|'.
    std::string prints(const std::string& chunk);
    /// One fixed step, as the loop makes it.
    void step(int count = 1);
    /// Lines of a console command joined with '|'; "error: message" when it failed.
    std::string console(const std::string& command);
    Value get(const std::string& path) const;

    Module module;
    std::unique_ptr<Tree> tree = std::make_unique<Tree>();
    std::unique_ptr<fettle::script::Runtime> runtime;
    std::vector<std::string> printed;
    std::vector<ScriptError> errors;
    Handle world;
    double now = 0;
};

std::string joined(const std::vector<std::string>& lines);

/// Matches a text with this beginning.
inline auto starts_with(const std::string& part) {
    return Catch::Matchers::StartsWith(part);
}

}  // namespace stage
