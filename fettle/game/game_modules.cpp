#include <game/game_modules.h>

#include <map>
#include <set>

#include <fettle/property/spelling.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/game_settings.h>

#ifdef FETTLE_WITH_PHYSICS
#include <fettle/physics_module/physics_module.h>
#endif

#include <files/archive.h>
#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;
using property::Row;
using property::Type;
using property::Value;

namespace {

constexpr const char* manifest_name = "modules.json";

void each_in_manifest(const fs::path& game, const std::function<void(const std::string&)>& visit) {
    property::GameFiles files;
    files.stay_below(folder_of(game));
    if (const auto archive = archive_of(game); !archive.empty())
        for (auto& [name, content] : read_archive(archive, manifest_name))
            files.put(archive / name, std::move(content));
    property::read_module_list(files, folder_of(game), visit);
}

/// The nearest name of a module in the folders, as " (did you mean ...)"; with `ending`, of a file.
std::string nearest(const std::string& name, std::initializer_list<fs::path> folders, bool ending) {
    std::set<std::string> known;
    for (const fs::path& folder : folders) {
        std::error_code error;
        for (fs::directory_iterator it(folder, error), end; !error && it != end;
             it.increment(error))
            if (it->path().extension() == ".so")
                known.insert((ending ? it->path().filename() : it->path().stem()).string());
    }
#ifdef FETTLE_WITH_PHYSICS
    if (!ending) known.insert("physics");
#endif
    return property::suggestion(name, std::vector<std::string>(known.begin(), known.end()));
}

/// Throws FileError with the nearest name if there is nothing of that name.
fs::path existing(const fs::path& file) {
    std::error_code error;
    const std::string name = file.filename().string();
    const std::string near =
        fs::exists(file, error) ? "" : nearest(name, {file.parent_path()}, true);
    if (!near.empty()) throw FileError(file.string() + ": there is no such file" + near);
    return file;
}

bool is_path(const std::string& name) {
    const fs::path file(name);
    return file.has_parent_path() || file.extension() == ".so";
}

}  // namespace

std::vector<std::string> manifest(const fs::path& game) {
    std::vector<std::string> names;
    each_in_manifest(game, [&](const std::string& name) { names.push_back(name); });
    return names;
}

fs::path module_file(const std::string& name, const fs::path& game) {
    const fs::path given(name);
    const fs::path folder = folder_of(game);
    if (name.empty()) throw FileError("a module: expected a file or a name, got an empty text");
    if (is_path(name)) {
        std::error_code error;
        return existing(given.is_absolute() || fs::exists(given, error) ? given : folder / given);
    }
    fs::path beside = folder / (name + ".so");
    std::error_code error;
    if (fs::exists(beside, error)) return beside;
    fs::path installed = installed_modules() / (name + ".so");
    if (fs::exists(installed, error)) return installed;
    throw FileError("module \"" + name + "\": there is neither " + beside.string() + " nor " +
                    installed.string() +
                    nearest(name, {beside.parent_path(), installed.parent_path()}, false));
}

fs::path listed_module_file(const std::string& name, const fs::path& game) {
    return is_path(name) ? existing((folder_of(game) / name).lexically_normal())
                         : module_file(name, game);
}

/// A plugged-in module, with the values that `game.modules` shows.
struct GameModules::Plugged {
    module::Plugin* plugin = nullptr;
    fs::file_time_type changed{};
    bool reload_requested = false;
    bool follow = false;  // reload when the file changes
    std::int64_t reloads = 0;
    std::string problem;  // of the last reload; "" if it succeeded
};

GameModules::GameModules(const fs::path& game, std::span<const std::string> named) {
    each_in_manifest(game, [&](const std::string& name) {
        if (is_path(name) && !archive_of(game).empty())
            throw FileError("\"" + name +
                            "\": an archive brings no native code along; it can name modules that "
                            "are installed with Fettle");
        plugins_.open(listed_module_file(name, game));
    });
    for (const std::string& name : named) {
        const fs::path file = module_file(name, game);
        plugins_.open(file);
        named_.push_back(fs::absolute(file).string());
    }
    files_.push_back(folder_of(game) / manifest_name);
    for (const auto& plugin : plugins_.all()) files_.push_back(plugin->file());
#ifdef FETTLE_WITH_PHYSICS
    if (plugins_.find("physics") == nullptr)
        built_in_.push_back(std::make_unique<physics_module::PhysicsModule>());
#endif
}

GameModules::~GameModules() = default;

/// A class that is named may be one of a later module.
void GameModules::require_classes_of_references(const property::Tree& tree) const {
    std::vector<std::string> names;
    for (const property::Class* each : tree.classes()) names.push_back(each->name());
    const auto require = [&](const std::string& of, const std::string& wanted) {
        if (!wanted.empty() && tree.find_class(wanted) == nullptr)
            throw FileError("a module: " + of + " refers to a class \"" + wanted +
                            "\", which no module has" + property::suggestion(wanted, names));
    };
    if (plugins_.all().empty()) return;
    for (const property::Class* each : tree.classes()) {
        for (const property::Property* p : each->properties())
            require(each->name() + "." + p->name, p->reference_class);
        for (const property::Method* m : each->methods())
            for (const auto* fields : {&m->parameters, &m->returns})
                for (const property::Field& field : *fields)
                    require(each->name() + ":" + m->name + "()", field.reference_class);
    }
}

void GameModules::attach(property::Tree& tree) {
    for (const auto& m : built_in_) m->attach(tree);
    std::map<const property::Class*, std::string> makers;
    const auto note_makers = [&](const std::string& of) {
        for (const property::Class* each : tree.classes()) makers.try_emplace(each, of);
    };
    note_makers("");
    for (const auto& plugin : plugins_.all()) {
        try {
            plugin->attach(tree);
        } catch (const module::LoadError& error) {
            for (const auto& [each, maker] : makers)
                if (!maker.empty() &&
                    std::string(error.what())
                        .ends_with("there is a class \"" + each->name() + "\" already"))
                    throw module::LoadError(error.what() + (", in the module " + maker));
            throw;
        }
        note_makers(std::string(plugin->name()));
    }
    require_classes_of_references(tree);
    if (!plugins_.all().empty()) define_service(tree);
}

std::vector<module::Module*> GameModules::all() const {
    std::vector<module::Module*> modules;
    for (const auto& m : built_in_) modules.push_back(m.get());
    for (const auto& plugin : plugins_.all()) modules.push_back(plugin.get());
    return modules;
}

void GameModules::on_print(std::function<void(std::string_view)> sink) {
    print_ = std::move(sink);
    for (const auto& plugin : plugins_.all()) plugin->on_print(print_);
}

void GameModules::on_error(
    const std::function<void(const std::string& module, const std::string& message)>& sink) {
    for (const auto& plugin : plugins_.all())
        plugin->on_error([sink, name = std::string(plugin->name())](const std::string& message) {
            sink(name, message);
        });
}

void GameModules::on_note(const std::function<void(const std::string&)>& sink) {
#ifdef FETTLE_WITH_PHYSICS
    for (const auto& m : built_in_)
        if (auto* const physics = dynamic_cast<physics_module::PhysicsModule*>(m.get()))
            physics->on_problem(sink);
#else
    (void)sink;
#endif
}

void GameModules::define_service(property::Tree& tree) {
    using property::accessor;
    const auto make_property = [&](const char* name, Type type, const char* doc,
                                   property::Binding binding) {
        return property::Property{
            .name = name, .type = type, .doc = doc, .binding = binding, .transient = true};
    };
    property::ClassDescriptor one;
    one.name = "PluggedModule";
    one.doc = "A module in a shared object that the game has plugged in.";
    one.creatable = false;
    one.properties = {
        make_property(
            "file", Type::text, "The file from which it was loaded.",
            accessor(*this,
                     [](GameModules& m, Row r) { return m.plugged_[r]->plugin->file().string(); })),
        make_property("version", Type::text, "Its version, as given by the module.",
                      accessor(*this, [](GameModules& m,
                                         Row r) { return m.plugged_[r]->plugin->version(); })),
        make_property(
            "reloads", Type::integer, "Number of reloads.",
            accessor(*this, [](GameModules& m, Row r) { return m.plugged_[r]->reloads; })),
        make_property(
            "problem", Type::text, "Why the last reload failed; empty if it did not.",
            accessor(*this, [](GameModules& m, Row r) { return m.plugged_[r]->problem; })),
        make_property("follow", Type::boolean, "Whether it is reloaded when its file changes.",
                      accessor(
                          *this, [](GameModules& m, Row r) { return m.plugged_[r]->follow; },
                          [](GameModules& m, Row r, const Value& v) {
                              m.plugged_[r]->follow = v.boolean();
                          }))};
    one.methods = {{.name = "reload",
                    .doc =
                        "Loads its file again when the next frame begins. Its instances stay, and "
                        "their values are copied by name.",
                    .context = this,
                    .call = [](void* context, property::Tree&, property::Handle, Row row,
                               std::span<const Value>) -> property::Result {
                        static_cast<GameModules*>(context)->plugged_[row]->reload_requested = true;
                        return Value();
                    }}};
    property::ClassDescriptor all_of_them;
    all_of_them.name = "Modules";
    all_of_them.doc = "The modules that the game has plugged in.";
    all_of_them.creatable = false;
    const property::Class& plugged = tree.define(std::move(one));
    const property::Handle service =
        tree.create(tree.define(std::move(all_of_them)), tree.root(), "modules");
    for (const auto& plugin : plugins_.all()) {
        Plugged& made = *plugged_.emplace_back(std::make_unique<Plugged>());
        made.plugin = plugin.get();
        std::error_code error;
        made.changed = fs::last_write_time(plugin->file(), error);
        tree.set_row(tree.create(plugged, service, plugin->name()),
                     static_cast<Row>(plugged_.size() - 1));
    }
}

void GameModules::renew() {
    // Checking a file is slow, so it is done only every 15th frame (four times a second).
    const bool look = ++frames_ % 15 == 0;
    for (const auto& plugged : plugged_) {
        if (plugged->follow && look) {
            std::error_code error;
            const auto changed = fs::last_write_time(plugged->plugin->file(), error);
            if (!error && changed != plugged->changed) plugged->reload_requested = true;
        }
        if (plugged->reload_requested) reload(*plugged);
    }
}

void GameModules::reload(Plugged& plugged) {
    plugged.reload_requested = false;
    std::error_code error;
    plugged.changed = fs::last_write_time(plugged.plugin->file(), error);
    const std::string name(plugged.plugin->name());
    try {
        const module::Reloaded reloaded = plugged.plugin->reload();
        ++plugged.reloads;
        plugged.problem.clear();
        if (print_)
            print_("module " + name + " reloaded: " + std::to_string(reloaded.instances) +
                   " instances, " + std::to_string(reloaded.values) + " values");
        for (const std::string& note : reloaded.notes)
            if (print_) print_("  " + note);
    } catch (const module::LoadError& problem) {
        plugged.problem = problem.what();
        if (print_) print_(plugged.problem + "; the module goes on as it was");
    }
}

}  // namespace fettle::program
