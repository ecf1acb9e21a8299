// The `fettle` program: one file a subcommand.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "docs.h"
#include "exit_status.h"
#include "run.h"
#include "version.h"

int main(int argc, char** argv) {
    using namespace fettle::program;
    CLI::App app("Fettle: 2D games in which every property of every object is live.", "fettle");
    app.set_version_flag("--version", version_text());
    app.require_subcommand(1);
    int status = success;
    add_run(app, status);
    add_docs(app, status);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? success : bad_usage;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fettle: %s\n", error.what());
        return script_error;
    }
    return status;
}
