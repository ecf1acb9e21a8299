// The saved state of a physics world: arbitrary bytes, and a valid state with some changed bytes.
// It is refused, or restored to a world that can be stepped and whose objects can be destroyed. The
// checksum is corrected after a change; otherwise it alone would refuse the state.

#include <cstring>
#include <stdexcept>
#include <vector>

#include <fettle/physics/physics.h>
#include <saving/checksum.h>

using namespace fettle::physics;

namespace {

std::vector<std::byte> true_state() {
    World world;
    Body floor = world.create_body({.type = BodyType::static_body});
    floor.add(Box{.width = 20, .height = 1});
    for (int i = 0; i < 5; ++i) {
        Body body = world.create_body(
            {.position = {0.1f * static_cast<float>(i), 1.0f + static_cast<float>(i)}});
        body.add(Circle{.radius = 0.4f});
    }
    Body car = world.create_body({.position = {3, 2}});
    car.add(Box{.width = 2, .height = 0.5f});
    Body wheel = world.create_body({.position = {3.5f, 1.5f}});
    wheel.add(Ellipse{.radius_x = 0.4f, .radius_y = 0.3f});
    car.set_mass(3.0f);
    world.create_wheel_joint({.body_a = car.id(), .body_b = wheel.id()});
    world.create_ratchet_joint({.body_a = floor.id(), .body_b = wheel.id()});
    world.create_field({.force = DragField{}});
    for (int i = 0; i < 40; ++i) world.step(1.0f / 60);
    std::vector<std::byte> bytes;
    world.save(bytes);
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::vector<std::byte> saved = true_state();
    std::vector<std::byte> bytes;
    if (size > 0 && data[0] % 2 == 0) {
        bytes.resize(size - 1);
        if (size > 1) std::memcpy(bytes.data(), data + 1, size - 1);
    } else {
        bytes = saved;
        for (std::size_t i = 1; i + 2 < size; i += 3) {
            const std::size_t at = (std::size_t{data[i]} << 8 | data[i + 1]) * 7 % bytes.size();
            bytes[at] = static_cast<std::byte>(data[i + 2]);
        }
    }
    // One input in four keeps the wrong checksum and must be refused.
    if (size == 0 || data[0] % 4 != 3) detail::write_checksum(bytes);
    World world;
    try {
        world.restore(bytes);
    } catch (const std::invalid_argument&) {
        return 0;
    }
    for (int i = 0; i < 3; ++i) world.step(1.0f / 60);
    for (Body body : world.bodies()) {
        body.destroy();
        if (body.id().index % 2 == 0) world.step(1.0f / 60);
    }
    return 0;
}
