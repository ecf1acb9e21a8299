#include "calls.h"

#include <fettle/physics_c/keep_error.h>

#include <new>
#include <stdexcept>

namespace fettle::host {

namespace {

fettle_code code_of(property::ErrorKind kind) {
    using Kind = property::ErrorKind;
    switch (kind) {
        case Kind::deleted:
            return FETTLE_STALE;
        case Kind::formula:
        case Kind::no_barrier_end:
            return FETTLE_FAILED;
        default:
            return FETTLE_INVALID;
    }
}

fettle_code store_error(fettle_code code, const char* function, const char* message) noexcept {
    fettle_keep_error(function, message);
    return code;
}

}  // namespace

fettle_code code_of_exception(const char* function) noexcept {
    try {
        throw;
    } catch (const Failure& failure) {
        return store_error(failure.code, function, failure.message.c_str());
    } catch (const property::Error& error) {
        return store_error(code_of(error.kind()), function, error.what());
    } catch (const std::bad_alloc&) {
        return store_error(FETTLE_NO_MEMORY, function, "there is not enough memory");
    } catch (const std::length_error&) {
        return store_error(FETTLE_NO_MEMORY, function, "there is not enough memory");
    } catch (const std::invalid_argument& error) {
        return store_error(FETTLE_INVALID, function, error.what());
    } catch (const std::exception& error) {
        return store_error(FETTLE_FAILED, function, error.what());
    } catch (...) {
        return store_error(FETTLE_FAILED, function,
                           "a function that was called threw an exception");
    }
}

Game& live(const fettle_hosted* hosted) {
    if (hosted == nullptr) throw Failure{FETTLE_INVALID, "game: expected a pointer, got null"};
    OneThread::require();
    if (hosted->game == nullptr) throw Failure{FETTLE_STALE, "game: it was destroyed"};
    return *hosted->game;
}

property::Value answer_of(Game& game, std::span<const property::Value> arguments,
                          const std::function<fettle_code(const fettle_hosted_value*, std::uint32_t,
                                                          fettle_hosted_value*)>& call) {
    ReturnedData given;
    std::vector<fettle_hosted_value> passed;
    for (const property::Value& argument : arguments) passed.push_back(given.value(argument));
    fettle_hosted_value result{};
    fettle_code code = FETTLE_DONE;
    game.call_out(
        [&] { code = call(passed.data(), static_cast<std::uint32_t>(passed.size()), &result); });
    property::Value value;
    try {
        value = value_of("the result of the function", result);
    } catch (const Failure& failure) {  // the game knows std::exception only
        throw std::invalid_argument(failure.message);
    }
    if (code == FETTLE_DONE) return value;
    const bool has_reason = value.is(property::Type::text) && !value.text().empty();
    throw std::invalid_argument(has_reason ? value.text()
                                           : "the function of the host failed with the code " +
                                                 std::to_string(code));
}

property::Handle living(const Game& game, fettle_instance instance) {
    const property::Handle handle = handle_of(instance);
    if (!handle)
        throw Failure{FETTLE_STALE, "instance " + std::to_string(instance) + ": there is none"};
    game.tree.require(handle);
    return handle;
}

void refuse_property(fettle_property_id id) {
    throw Failure{FETTLE_STALE, "property " + std::to_string(id) +
                                    ": there is no such handle, or it was released"};
}

}  // namespace fettle::host

const char* fettle_host_version(void) {
    return FETTLE_VERSION;
}
