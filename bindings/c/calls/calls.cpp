#include <calls/calls.h>

#include <fettle/physics_c/keep_error.h>

#include <cstdio>
#include <stdexcept>

namespace fettle::physics_c {
namespace {

thread_local char last_error[1024] = "";

fettle_code store_error(fettle_code code, const char* function, const char* message) noexcept {
    std::snprintf(last_error, sizeof last_error, "%s: %s", function, message);
    return code;
}

}  // namespace

fettle_code code_of_exception(const char* function) noexcept {
    try {
        throw;
    } catch (const Failure& failure) {
        return store_error(failure.code, function, failure.message.c_str());
    } catch (const physics::Locked& error) {
        return store_error(FETTLE_LOCKED, function, error.what());
    } catch (const std::invalid_argument& error) {
        return store_error(FETTLE_INVALID, function, error.what());
    } catch (const physics::Damaged& error) {
        return store_error(FETTLE_NO_MEMORY, function, error.what());
    } catch (const std::bad_alloc&) {
        return store_error(FETTLE_NO_MEMORY, function, "there is not enough memory");
    } catch (const std::length_error&) {
        return store_error(FETTLE_NO_MEMORY, function, "there is not enough memory");
    } catch (const std::exception& error) {
        return store_error(FETTLE_FAILED, function, error.what());
    } catch (...) {
        return store_error(FETTLE_FAILED, function,
                           "a function that was called threw an exception");
    }
}

float checked(const Finite& number) {
    if (!std::isfinite(number.value))
        throw Failure{FETTLE_INVALID,
                      name_and_value(number.name, number.value) + ": expected a finite number"};
    return number.value;
}

uint16_t checked(const Material& material) {
    if (material.value > 0xffffu)
        throw Failure{FETTLE_INVALID, "material = " + std::to_string(material.value) +
                                          ": expected a whole number from 0 to 65535"};
    return uint16_t(material.value);
}

physics::Vec2 checked(const FiniteVector& vector) {
    return {checked(Finite{"x", vector.x}), checked(Finite{"y", vector.y})};
}
physics::Position checked(const FinitePoint& point) {
    // A coordinate beyond the range of a float is as good as infinite.
    checked(FiniteVector{float(point.x), float(point.y)});
    return {point.x, point.y};
}

}  // namespace fettle::physics_c

using namespace fettle::physics_c;

const char* fettle_last_error(void) {
    return last_error;
}

void fettle_keep_error(const char* function, const char* message) {
    store_error(FETTLE_FAILED, function == nullptr ? "" : function,
                message == nullptr ? "" : message);
}

const char* fettle_physics_version(void) {
    return FETTLE_VERSION;
}

int32_t fettle_simd_width(void) {
    return fettle::physics::simd_width();
}
