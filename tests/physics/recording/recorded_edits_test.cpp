#include <fettle/physics/recording.h>

#include <random>

#include "catch.h"
#include "scenes.h"
#include "thorough.h"

namespace recorded_edits_test {

// A recording changes nothing, whatever is edited before and after its start.

using namespace scenes;
using Bytes = std::vector<std::byte>;

namespace {

class EditedWorld {
  public:
    explicit EditedWorld(unsigned seed) : engine_(seed) {
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Chain{.points = {{-8, 8}, {-8, 0}, {0, 1}, {8, 0}, {8, 8}}});
        for (int i = 0; i < 24; ++i) spawn();
    }

    void edit() {
        const size_t place = std::min(size_t(number(0, float(bodies_.size()))), bodies_.size() - 1);
        Body body = bodies_[place];
        switch (int(number(0, 9))) {
            case 0:
                return spawn();
            case 1:
                return body.set_type(BodyType::kinematic_body);
            case 2:
                return body.set_type(BodyType::static_body);
            case 3:
                return body.set_type(BodyType::dynamic_body);
            case 4:
                return body.set_mass(number(0.1f, 10));
            case 5:
                return body.set_enabled(!body.enabled());
            case 6:
                return body.set_position({number(-7, 7), number(2, 9)});
            case 7:
                return body.shapes()[0].set_geometry(Circle{.radius = number(0.1f, 0.5f)});
            default:
                body.destroy();
                bodies_.erase(bodies_.begin() + std::ptrdiff_t(place));
                return spawn();
        }
    }
    float number(float low, float high) {
        return low + (high - low) * float(engine_()) / 4294967296.0f;
    }

    World world;

  private:
    void spawn() {
        const Position place = {number(-7, 7), number(2, 9)};
        Body body = world.create_body({.position = place, .angle = number(0, 6)});
        const int form = int(number(0, 4));
        if (form == 0)
            body.add(Circle{.radius = number(0.1f, 0.5f)});
        else if (form == 1)
            body.add(Box{.width = number(0.2f, 1), .height = 0.4f});
        else
            body.add(Concave{.vertices = {{-0.5f, -0.4f},
                                          {0.5f, -0.4f},
                                          {0.5f, 0.4f},
                                          {0.3f, 0.4f},
                                          {0.3f, -0.1f},
                                          {-0.3f, -0.1f},
                                          {-0.3f, 0.4f},
                                          {-0.5f, 0.4f}}});
        bodies_.push_back(body);
    }

    std::mt19937 engine_;
    std::vector<Body> bodies_;
};

/// The hashes after each step. The recording begins between two edits before step `begin`, and it
/// is replayed.
std::vector<uint64_t> hashes_of(unsigned seed, int begin) {
    EditedWorld edited(seed);
    Bytes bytes;
    std::vector<uint64_t> hashes;
    for (int step = 0; step < 90; ++step) {
        for (int edits = int(edited.number(0, 3)); edits > 0; --edits) edited.edit();
        if (step == begin)
            edited.world.start_recording([&](std::span<const std::byte> more) {
                bytes.insert(bytes.end(), more.begin(), more.end());
            });
        edited.edit();
        edited.world.step(frame);
        hashes.push_back(edited.world.hash());
    }
    if (bytes.empty()) return hashes;
    Replay replay(bytes);
    while (const auto step = replay.step()) REQUIRE(step->same);
    REQUIRE(replay.steps() == uint64_t(90 - begin));
    REQUIRE(replay.world().hash() == edited.world.hash());
    return hashes;
}

}  // namespace

TEST_CASE("recording changes no result of edits before and after its start") {
    for (unsigned seed = 1; seed <= (thorough() ? 20 : 5); ++seed) {
        INFO("seed " << seed);
        const std::vector<uint64_t> plain = hashes_of(seed, -1);
        REQUIRE(hashes_of(seed, 0) == plain);
        REQUIRE(hashes_of(seed, 30) == plain);
    }
}

}  // namespace recorded_edits_test
