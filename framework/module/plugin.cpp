#include <fettle/module/plugin.h>

#include <cstdio>

#include <fettle/property/bytes.h>
#include <fettle/property/ended_class.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>

#include "abi_check.h"
#include "plugin_state.h"
#include "trial/trial.h"

namespace fettle::module {

namespace fs = std::filesystem;

OpenModule Plugin::State::open_file(const fs::path& copy) {
    OpenModule opened;
    opened.object = SharedObject(copy, file);
    const auto entry =
        reinterpret_cast<fettle_module_entry>(opened.object.symbol(FETTLE_MODULE_ENTRY));
    if (entry == nullptr)
        throw LoadError(file, "expected a module with the function " FETTLE_MODULE_ENTRY
                              ", found a shared object without it");
    opened.native.struct_size = sizeof opened.native;
    const fettle_status status = entry(&host.table(), &opened.native);
    const std::string reason = host.take_reason();
    require_supported_abi(file, opened.native.abi);
    if (status != FETTLE_OK)
        throw LoadError(file, "the module refuses: " +
                                  (reason.empty() ? "status " + std::to_string(status) : reason));
    if (opened.native.abi == 0)
        throw LoadError(file, "expected a module that sets its version, found `abi` 0");
    if (!property::is_identifier(view(opened.native.name)))
        throw LoadError(file, "expected a module with an identifier for its name, found \"" +
                                  text_or_empty(opened.native.name) + "\"");
    if (opened.native.attach == nullptr)
        throw LoadError(file, "expected a module with `attach`, found none");
    if ((opened.native.save == nullptr) != (opened.native.restore == nullptr))
        throw LoadError(file,
                        "expected a module with both `save` and `restore`, or neither; found "
                        "one of them");
    return opened;
}

void Plugin::State::prepare(property::Tree& tree) {
    host.tree = &tree;
    host.define_class = [this](const fettle_class& native) {
        classes.push_back(std::make_unique<BridgedClass>(host, native));
    };
}

void Plugin::State::attach_native() {
    {
        const Running running(host.named, "attach");
        host.require(open.native.attach(open.native.context), "attach");
    }
    host.define_class = nullptr;
    if (saves()) return;
    for (const auto& c : classes)
        if (c->saved_natively())
            throw std::runtime_error("class " + c->declared().name() +
                                     " leaves its rows to `save` and `restore` of the module, "
                                     "which has not both");
}

void Plugin::State::check_native() {
    if (open.native.check == nullptr) return;
    const Running running(host.named, "check");
    host.require(open.native.check(open.native.context), "its own test");
}

void Plugin::State::step_once() {
    constexpr double dt = 1.0 / 60;
    step(dt);
    report();
    (void)hash();
}

void Plugin::State::step(double dt) {
    const fettle_module& native = open.native;
    if (native.step != nullptr)
        host.run(host.named, "step", [&] { native.step(native.context, dt); });
}

void Plugin::State::report() {
    const fettle_module& native = open.native;
    if (native.report != nullptr)
        host.run(host.named, "report", [&] { native.report(native.context); });
}

std::uint64_t Plugin::State::hash() {
    const fettle_module& native = open.native;
    if (native.hash == nullptr) return 0;
    return host.run(host.named, "hash", [&] { return native.hash(native.context); });
}

void Plugin::State::close_native() {
    // Exceptions of `close` are reported only: nothing can handle them any more.
    try {
        const fettle_module& native = open.native;
        if (native.close != nullptr)
            host.run(host.named, "close", [&] { native.close(native.context); });
    } catch (...) {
        if (host.print)
            host.print("module " + name + ": its `close` threw: " + property::exception_text());
    }
    open.native = {};
}

void Plugin::State::abandon() {
    host.define_class = nullptr;
    host.adopt = nullptr;
    host.unknown = nullptr;
    for (const auto& c : classes) c->abandon();
    close_native();
}

void Plugin::State::leave_tree() {
    property::Tree& tree = *host.tree;
    if (host.part != nullptr) tree.remove_part(*host.part);
    host.part = nullptr;
    for (const auto& c : classes) property::end_class(tree, c->declared());
    host.tree = nullptr;
}

void Plugin::State::require_loaded() const {
    if (open.native.attach == nullptr)
        throw std::runtime_error("module " + name + " is not loaded any more");
}

namespace {

void try_to_open(const fs::path& file, const fs::path& copy,
                 std::vector<fs::path>* libraries = nullptr) {
    const std::string problem =
        run_trial({.kind = TrialKind::open, .file = file, .copy = copy, .name = ""}, libraries);
    if (!problem.empty())
        throw problem.starts_with(file.string()) ? LoadError(problem)
                                                 : LoadError(file, "the module " + problem);
}

}  // namespace

std::vector<fs::path> needed_libraries(const fs::path& file) {
    const ModuleCopy copy(file);
    std::vector<fs::path> all;
    try_to_open(file, copy.path(), &all);
    std::erase(all, fs::absolute(copy.path()));
    return all;
}

// --- Plugin

std::unique_ptr<Plugin> Plugin::open(const fs::path& file) {
    auto state = std::make_unique<State>();
    state->file = file;
    state->opened_copy = std::make_unique<ModuleCopy>(file);
    const fs::path& copy = state->opened_copy->path();
    try_to_open(file, copy);
    state->open = state->open_file(copy);
    state->identity = identity(file);
    state->name = text_or_empty(state->open.native.name);
    state->version = text_or_empty(state->open.native.version);
    state->host.named.module = state->name.c_str();
    state->host.print = [](std::string_view line) {
        std::fwrite(line.data(), 1, line.size(), stdout);
        std::fputc('\n', stdout);
    };
    return std::unique_ptr<Plugin>(new Plugin(std::move(state)));
}

Plugin::Plugin(std::unique_ptr<State> state) : state_(std::move(state)) {}

Plugin::~Plugin() {
    State& s = *state_;
    if (s.host.tree != nullptr && !s.tree_life.expired()) s.leave_tree();
    s.host.tree = nullptr;
    s.close_native();
}

const fs::path& Plugin::file() const {
    return state_->file;
}
const std::string& Plugin::version() const {
    return state_->version;
}
std::string_view Plugin::name() const {
    return state_->name;
}
void Plugin::on_print(std::function<void(std::string_view)> sink) {
    state_->host.print = std::move(sink);
}

void Plugin::on_error(std::function<void(const std::string&)> sink) {
    state_->host.failed = std::move(sink);
}

void Plugin::attach(property::Tree& tree) {
    State& s = *state_;
    if (s.host.tree != nullptr) throw std::logic_error(s.name + " is attached to a tree already");
    if (s.open.native.attach == nullptr)
        throw LoadError(s.file, "module " + s.name + " is not loaded any more");
    const std::string problem = run_trial({.kind = TrialKind::attach,
                                           .file = s.file,
                                           .copy = s.opened_copy->path(),
                                           .name = s.name,
                                           .tree = described(tree, {})});
    if (!problem.empty()) throw LoadError(s.file, "module " + s.name + ": " + problem);
    s.prepare(tree);
    try {
        s.attach_native();
    } catch (...) {  // an error that did not occur in the trial
        const std::string reason = property::exception_text();
        s.abandon();
        s.leave_tree();
        throw LoadError(s.file, "module " + s.name + ": " + reason);
    }
    s.opened_copy.reset();
    s.tree_life = tree.lifetime();
    if (!s.saves()) return;
    tree.add_part(*this);
    s.host.part = this;
}

void Plugin::step(double dt) {
    state_->step(dt);
}

void Plugin::report(property::Tree&) {
    state_->report();
}

std::uint64_t Plugin::hash() const {
    return state_->hash();
}

property::Memory Plugin::save(property::ByteWriter& to) const {
    State& s = *state_;
    s.require_loaded();
    const auto write = [](void* sink, const void* data, std::size_t size) {
        static_cast<property::ByteWriter*>(sink)->raw(data, size);
    };
    try {
        const Running running(s.host.named, "save");
        s.host.require(s.open.native.save(s.open.native.context, &to, write), "save");
    } catch (const std::exception& problem) {
        throw property::Error(property::ErrorKind::rejected,
                              "module " + s.name + " cannot be saved: " + problem.what());
    }
    return {};
}

std::function<void()> Plugin::restore(property::ByteReader& from, const property::Memory&) {
    State& s = *state_;
    s.require_loaded();
    const auto bytes =
        std::make_shared<std::vector<std::byte>>(from.rest().begin(), from.rest().end());
    const auto call = [&s, bytes](std::uint32_t commit) {
        const Running running(s.host.named, "restore");
        return s.open.native.restore(s.open.native.context, bytes->data(), bytes->size(), commit);
    };
    const fettle_status checked = call(0);
    const std::string reason = s.host.take_reason();
    if (checked != FETTLE_OK) from.fail(reason);
    from = property::ByteReader({});
    return [&s, call] {
        s.host.run(s.host.named, "restore", [&] {
            if (call(1) != FETTLE_OK) s.host.fail_unless_failed("it did not finish");
        });
        for (const auto& c : s.classes) c->recount();
    };
}

void Plugin::refresh(std::uint64_t what) {
    State& s = *state_;
    const fettle_module& native = s.open.native;
    if (native.refresh != nullptr)
        s.host.run(s.host.named, "refresh", [&] { native.refresh(native.context, what); });
}

// --- Plugins

Plugin& Plugins::open(const fs::path& file) {
    const FileIdentity wanted = identity(file);
    if (wanted != FileIdentity{})
        for (const auto& plugin : plugins_)
            if (identity(plugin->file()) == wanted)
                throw LoadError(
                    file, "it is loaded already, as the module " + std::string(plugin->name()));
    std::unique_ptr<Plugin> plugin = Plugin::open(file);
    if (const Plugin* other = find(plugin->name()))
        throw LoadError(file, "a module called " + std::string(plugin->name()) +
                                  " is loaded already, from " + other->file().string());
    return *plugins_.emplace_back(std::move(plugin));
}

Plugin* Plugins::find(std::string_view name) const {
    for (const auto& plugin : plugins_)
        if (plugin->name() == name) return plugin.get();
    return nullptr;
}

}  // namespace fettle::module
