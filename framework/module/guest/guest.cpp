// The entry point of a module in C++, and its callbacks in C.

#include <fettle/module/guest.h>

#include <functional>
#include <string>
#include <vector>

#include <fettle/property/bytes.h>

#include "guest_tree.h"

namespace fettle::module {
namespace {

/// A module and its tree. The tree is destroyed first.
struct Guest {
    std::unique_ptr<Module> module;
    property::Tree tree;
    std::function<void()> finish_restore;  // second part of `restore`: writes the checked data
};

Guest& guest_of(void* context) {
    return *static_cast<Guest*>(context);
}

fettle_status attach(void* context) {
    Guest& guest = guest_of(context);
    return guest.tree.state().answer([&] { guest.module->attach(guest.tree); });
}

/// Runs `body` and reports an exception, for callbacks that return no status.
template <class Body>
void run(Guest& guest, Body&& body) noexcept {
    guest.tree.state().run([&] {
        guest.tree.state().follow_listeners();
        body();
    });
}

void step(void* context, double dt) {
    Guest& guest = guest_of(context);
    run(guest, [&] { guest.module->step(dt); });
}

void report(void* context) {
    Guest& guest = guest_of(context);
    run(guest, [&] { guest.module->report(guest.tree); });
}

std::uint64_t hash(void* context) {
    Guest& guest = guest_of(context);
    std::uint64_t value = 0;
    run(guest, [&] { value = guest.module->hash(); });
    return value;
}

fettle_status save(void* context, void* sink,
                   void (*bytes)(void* sink, const void* data, size_t size)) {
    Guest& guest = guest_of(context);
    return guest.tree.state().answer([&] {
        std::vector<std::byte> all;
        property::ByteWriter writer(all);
        if (const property::SnapshotPart* part = guest.tree.state().part) (void)part->save(writer);
        bytes(sink, all.data(), all.size());
    });
}

fettle_status restore(void* context, const void* data, size_t size, std::uint32_t commit) {
    Guest& guest = guest_of(context);
    return guest.tree.state().answer([&] {
        if (commit == 0) {
            property::SnapshotPart* part = guest.tree.state().part;
            property::ByteReader reader(
                std::span(static_cast<const std::byte*>(data), data == nullptr ? 0 : size),
                guest.tree.state().module);
            guest.finish_restore = part == nullptr ? nullptr : part->restore(reader, {});
        } else if (guest.finish_restore) {
            guest.finish_restore();
            guest.finish_restore = nullptr;
        }
    });
}

void refresh(void* context, std::uint64_t what) {
    Guest& guest = guest_of(context);
    run(guest, [&] {
        if (property::SnapshotPart* part = guest.tree.state().part) part->refresh(what);
    });
}

void close(void* context) {
    delete &guest_of(context);
}

const fettle_host* opened_by = nullptr;

}  // namespace

const fettle_host* program() {
    return opened_by;
}

fettle_status open_guest(const fettle_host* host, fettle_module* module, const char* version,
                         std::unique_ptr<Module> (*make)()) {
    module->abi = FETTLE_ABI;
    if (host->abi >> 16 != FETTLE_ABI_MAJOR || int(host->abi & 0xffff) < FETTLE_ABI_MINOR)
        return FETTLE_ERR_WRONG_VERSION;
    try {
        opened_by = host;
        auto guest = std::make_unique<Guest>();
        guest->tree.state().host = host;
        guest->module = make();
        std::string& name = guest->tree.state().module;
        name = guest->module->name();
        module->name = name.c_str();
        module->version = version;
        module->attach = attach;
        module->step = step;
        module->report = report;
        module->hash = hash;
        module->save = save;
        module->restore = restore;
        module->close = close;
        module->refresh = refresh;
        module->context = guest.release();
        return FETTLE_OK;
    } catch (const std::exception& error) {
        host->fail(host->self, error.what());
    } catch (...) {
        host->fail(host->self, "an exception of no known type");
    }
    return FETTLE_ERR_FAILED;
}

}  // namespace fettle::module
