#include <cstring>

#include <reference/language.h>
#include <reference/signature.h>

namespace fettle::script {

const std::vector<GlobalDoc>& global_docs() {
    static const std::vector<GlobalDoc> docs = {
        {"ab", "ab(path?: string, value?: any, seconds?: number)",
         "Shows the last seconds twice, side by side: A as they passed, and B with that value of "
         "the property from their beginning on. Each picture has the shapes, colors and view of "
         "its "
         "moment. Scripts do not run again: what they wrote then is written in B, too. seconds: 4 "
         "if it is left out, 0.1 to 60. The game does not change. "
         "Without a path the comparison ends. ab(\"world.ball.mass\", 3)."},
        {"after", "after(seconds: number, action: fun(), options?: table): Connection",
         "Calls the function once, after that much simulation time. The function may call "
         "wait(). after(1, f, { pauses = false }) counts real time, also while the game is paused; "
         "going back in time does not change it, and no saved game contains it."},
        {"alias", "alias(word: string, command?: string)",
         "In the console the word stands for the command; what is typed after it is put after "
         "the command. Without a command the alias is removed. `alias` alone lists them."},
        {"aliases", "aliases(): table<string, string>",
         "The words that stand for commands, with the commands. In the console the parentheses "
         "may be left out."},
        {"bind", "bind(key: string, command?: string)",
         "Runs the command whenever the key goes down, also while the console is closed: "
         "bind(\"f5\", \"rewind(5)\"). Keys have the names of the class Keys. The game does not "
         "get the key. Without a command the game gets the key again. `bind` alone lists them."},
        {"binds", "binds(): table<string, string>",
         "The keys that run commands, with the commands. In the console the parentheses may be "
         "left out."},
        {"bookmark", "bookmark(name?: string, step?: integer)",
         "Sets a bookmark on the time bar of the console: at the present step if step is left out. "
         "The same name again moves it. Bookmarks end with the run, because another run has "
         "other steps. `bookmark` alone, without parentheses, lists them."},
        {"bookmarks", "bookmarks(): table",
         "The steps of the bookmarks by their names: time:go_to(bookmarks().start) goes to one."},
        {"break_when", "break_when(condition?: string|fun(): any)",
         "Pauses the game after the step in which the condition becomes true, and prints its old "
         "and new value and what wrote it. If the value is not a boolean, the game pauses when it "
         "changes. "
         "`break_when` alone, without parentheses, lists the conditions; `unbreak` ends one, and "
         "break_when() all."},
        {"breaks", "breaks(): string[]",
         "The conditions that `break_when` waits for, as texts. In the console the parentheses may "
         "be left out."},
        {"class", "class(name: string, base?: Class|string): fun(members: table): Class",
         "Defines a class whose instances are in the tree: Ball = class(\"Ball\", Body) { lives "
         "= 3 }. Values are properties with their defaults; `doc` describes the class, or its "
         "properties by name."},
        {"clear", "clear()", "Empties the log of the console."},
        {"color",
         "color(name: string): color\n"
         "color(r: number, g: number, b: number, a?: number): color",
         "A color by name, as \"#rgb\" or \"#rrggbb\", with one or two digits more for its "
         "opacity, "
         "or from channels between 0 and 1."},
        {"compare_branch", "compare_branch(branch?: string)",
         "Shows the present branch of the past and another one side by side, from the step where "
         "they part, and lists the values that differ at their last common step. Without a name "
         "it is the branch that was left last; ab() ends it. time:branches() lists the branches."},
        {"deg", "deg(degrees: number): number", "An angle in radians."},
        {"delete_save", "delete_save(slot: string)", "Removes a saved game."},
        {"drop_tweaks", "drop_tweaks(pattern: string)",
         "Drops the tweaks that match: they are no longer listed or made again."},
        {"edit", "edit(name: string, action: fun())",
         "All writes of the function are one step of undo with that name."},
        {"every", "every(seconds: number, action: fun(), options?: table): Connection",
         "Calls the function repeatedly at that interval of simulation time; 0 means every step. "
         "every(1, f, { pauses = false }) counts real time, as `after` does, and calls it once a "
         "picture at most."},
        {"exec", "exec(file: string)",
         "Runs the commands in a file of the game, as if they were typed into the console."},
        {"export_plot", "export_plot(kind?: string)",
         "Writes what is plotted to a new file in the player's folder of the game: \"csv\" with "
         "all values, or \"png\" as a picture. The console prints its path."},
        {"find", "find(word: string)",
         "Lists every name and description that contains the word; for a condition such as \"mass "
         "> 5 "
         "and awake\", the instances for which it holds."},
        {"formula", "formula(value: fun(): any): Formula",
         "Assigned to a property, the function computes its value: it is called again whenever "
         "something that it reads has changed. If it raises an error, the error is reported "
         "once, the module continues with the last value, and reading the property raises the "
         "error. More than 50 million instructions are an error, too."},
        {"go_to_scene", "go_to_scene(name: string, options?: table)",
         "Replaces game.scene at the next barrier. The name is that of a class of the game, of "
         "which "
         "an instance is made, or of a scene file: \"level_2\" is scenes/level_2.json or "
         "level_2.json. What the old scene owns ends with it: its instances with their timers, "
         "tweens, "
         "coroutines, sounds and handlers, and what its `enter` began. Options: transition = "
         "\"none\" (the default), \"fade\", \"wipe\" or \"iris\"; seconds, of real time (0.5); "
         "color; args: what "
         "`enter` gets, a value of a property or a table of them by name."},
        {"go_on", "go_on()",
         "A command of the console: lets the game go on after an error at which it stopped, and "
         "after a pause. After going back, it goes on from there, as another branch."},
        {"help", "help(anything?: any)", "Explains a class, an instance, a method or a path."},
        {"history", "history()", "Lists the edits, the latest first."},
        {"keep", "keep(pattern: string)",
         "Writes the tweaks that match into files which the next run reads: tweaks of an "
         "instance of a scene file into that file, tweaks of an instance that a script made into "
         "`main.tweaks.json` beside `main.lua` (`NAME.tweaks.json` beside a game that is one "
         "file `NAME.lua`). If several instances come from the scene file, the tweaks of one of "
         "them are written into `main.tweaks.json`, too, for this one only. "
         "keep(\"world.ball.*\")."},
        {"keep_for_all", "keep_for_all(pattern: string)",
         "Writes the tweaks that match as `keep` does, but into the scene file also if several "
         "instances come from it: all of them have the change when the file is loaded again. "
         "Values that `keep` has written for one instance in this run are included."},
        {"last_time", "last_time(condition: string|fun(): any)",
         "Searches the kept past for the last step at which the condition was true, and goes "
         "there. If it is true now, it goes to the step at which it became true."},
        {"load_game", "load_game(slot: string)",
         "Continues with a saved game at the next barrier. A save that is damaged, newer, of "
         "another game or of classes that are not defined is an error, and nothing changes. "
         "`game` emits `restored`."},
        {"pin", "pin(what: string|fun(): any, ...: string|fun(): any)",
         "Adds a path or an expression to the watch list of the console: "
         "pin(\"world.ball.mass\"). `pin` alone lists what is pinned."},
        {"pins", "pins(): table<string, any>",
         "What is pinned, with the present values. In the console the parentheses may be left "
         "out."},
        {"play_back", "play_back(seconds?: number)",
         "In the console: shows the last seconds once more, as they were; then the game goes on, "
         "unless it was paused before. Without seconds, or with more than is kept, it "
         "begins with the oldest step that is kept. After going back it shows what followed."},
        {"plot", "plot(...: string|fun(): any)",
         "Shows values over time, of numbers, vectors and booleans, with the past as far as it is "
         "kept: plot(\"world.ball.velocity\"). plot() ends the plot; `plot` alone, without "
         "parentheses, lists what is plotted."},
        {"query", "query(pattern: string): Set|table<string, any>",
         "Finds what a pattern matches. If its last part is the name of a child, the result is a "
         "set of instances: query(\"world.*.circle\"). If it is the name of a property, or a "
         "star, which stands for every property, the result is a table of values by path: "
         "query(\"world.*.mass\"). If nothing matches, it is an empty set. Formulas in error are "
         "left out. A condition gives the set of instances for which it holds: query(\"Body and "
         "mass > 5 and position.x < 0\"). It can compare and compute, and calls nothing. The name "
         "of a class is a condition, unless `game` has something of that name: query(\"Body\")."},
        {"quit", "quit(status?: integer|boolean)",
         "Ends the game with that exit status, 0 to 255; 0 without one. It may be a handler: "
         "Button { text = \"Quit\", pressed = quit }."},
        {"random",
         "random(): number\n"
         "random(n: integer): integer\n"
         "random(from: integer, to: integer): integer\n"
         "random(from: number, to: number): number",
         "A random number in [0, 1), from 1 to n, or between the two arguments; random(x) with "
         "an x that is not an integer is between 0 and x; random(0) is any integer, as in Lua. "
         "The same seed gives the same numbers."},
        {"reapply_tweaks", "reapply_tweaks(pattern: string)",
         "Makes the matching tweaks of earlier runs again, and instances that were made, deleted "
         "or "
         "renamed later than this moment, before the game went back to it."},
        {"record", "record(on?: boolean)",
         "A command of the console, and the red button of the time bar: writes a recording of the "
         "run, from its first step to the present one and then all that follows, until "
         "record(false) or the end of the run. `fettle run --replay FILE` plays it again, and "
         "compares every step that was made while it was written. The file is in the folder "
         "`recordings` of the player's files, and the command prints where. This works for a run "
         "in a window until one of its files changes and is read again; for this purpose the first "
         "64 MB of a recording are kept."},
        {"redo", "redo(count?: integer)",
         "Repeats the last edit that undo reversed, or as many as `count` says."},
        {"require", "require(name: string): any",
         "Runs another file of the game once, and returns what it returned."},
        {"restart", "restart()",
         "A command of the console: begins the game again in its window, from its files as they "
         "are now. Edits that were not kept are listed by tweaks() after it. bind(\"f5\", "
         "\"restart()\") gives it a key."},
        {"restore", "restore(taken: Snapshot)",
         "Restores the whole tree from a snapshot, at the next barrier between steps. Variables "
         "of Lua are not changed; `game` emits `restored`."},
        {"rewind", "rewind(seconds: number)",
         "Goes back by that much simulation time, at the next barrier between steps, but not "
         "further than the timeline (`time.oldest`)."},
        {"save_game", "save_game(slot: string)",
         "Saves the game in that slot at the next barrier: the whole tree, but no variables of "
         "Lua; of a formula that uses local variables only the value. The name of a slot "
         "consists of letters, digits, spaces, - and _. Several calls for one slot before the "
         "barrier make one save, with the state that the last call wants; more than 1000 calls "
         "are an error. Saves are in a folder for each game in `~/.local/share/fettle/`."},
        {"saves", "saves(): SavedGame[]",
         "The saved games by slot, including those that cannot be loaded."},
        {"selection", "selection(instances?: Object[]|Object): Set?",
         "The instances that are selected in the console, `it` last; with a list or an instance, "
         "selects these. In a replay nothing is selected."},
        {"scene.load", "scene.load(file: string, parent?: Object, name?: string): Object",
         "Creates the instances of a scene file below the parent; detached without one."},
        {"scene.save", "scene.save(file: string, instance: Object)",
         "Writes an instance and everything below it to a scene file of the game. It may replace "
         "a scene file; a file of another kind is left unchanged, which is an error."},
        {"share", "share(name: string)",
         "A command of the console: writes this moment of the game into one file, with the game, "
         "its edits, and the recording if the run is recorded. `fettle run NAME.fettle` opens the "
         "game at this moment, paused. The name has letters, digits, - and _; the file is in the "
         "folder `moments` of the player's files, and the command prints where. Variables of "
         "scripts that are not in the tree, and timers, are not in it, as in a saved game."},
        {"snapshot", "snapshot(): Snapshot",
         "The whole tree as it is at the next barrier between steps, when the running function has "
         "ended, for restore: with what this function changes afterwards, too."},
        {"state", "state(name: string, value: any): any",
         "Declares a variable of the game that is a property of `game`: state(\"score\", 0). From "
         "then on, `score` reads and writes game.score, so it is saved, rewound, watched and "
         "inspected. The value is set only if there is none yet: one from a saved game or from "
         "before a reload stays. Returns the current value."},
        {"tweaks", "tweaks()",
         "Lists what people, and scripts inside edit(), changed while the game ran, in this run "
         "and in earlier ones, and which of these changes are kept. After going back it lists "
         "the changes of this run that hold at that moment."},
        {"tween",
         "tween(target: Object, property: string, to: any, seconds: number, ease?: "
         "string|number[]|fun(time: number): number, options?: table): Tween",
         "Moves a property from its value to another in that much simulation time. The property "
         "holds a number, an integer, a vector, a color, or a list of these. An ease is a name "
         "such as \"out_quad\" (`Tween.properties.ease.enumerators` lists them), a function from "
         "0..1 "
         "to 0..1, or a list of numbers. It begins at the next step; a tween that begins later "
         "with the same property ends it. Options are `pauses`, `loops` and `alternate` of the "
         "tween: tween(view, \"height\", 12, 1, \"linear\", { loops = 0, alternate = true })."},
        {"tween.parallel", "tween.parallel(tweens: any[]): TweenGroup",
         "Runs tweens and groups together. The list may have the options `pauses`, `loops` and "
         "`alternate` of the group: tween.parallel { a, b, loops = 2 }."},
        {"tween.sequence", "tween.sequence(tweens: any[]): TweenGroup",
         "Runs tweens and groups one after the other; a number is a pause in seconds. The list may "
         "have options of the group: tween.sequence { a, b, loops = 0, alternate = true }."},
        {"undo", "undo(count?: integer)", "Reverses the latest edit, or as many as `count` says."},
        {"unbookmark", "unbookmark(name?: string)",
         "Removes a bookmark; unbookmark() removes all."},
        {"unbreak", "unbreak(condition?: string)",
         "Ends one condition of `break_when`, which is named by its text; unbreak() ends all."},
        {"unpin", "unpin(what?: string)",
         "Removes an entry from the watch list; unpin() removes all."},
        {"vec",
         "vec(x: number, y: number): vec\n"
         "vec(other: vec): vec\n"
         "vec(): vec",
         "A vector or point; a copy of one; the zero vector."},
        {"wait",
         "wait(seconds: number)\n"
         "wait(condition?: string|function, seconds?: number)",
         "Inside a coroutine: continues after that much simulation time; real time in a function "
         "that a timer in real time has called. In a terminal (`fettle repl`): the next command "
         "runs after these seconds, or when the condition is true, after 60 seconds at most or as "
         "many as are given: `wait world.ball.position.y < 1`. wait() waits until the game is "
         "paused, as by `break_when`."},
        {"watch",
         "watch(pattern: string, handler: fun(new: any, old: any, change: Change)): Connection",
         "Calls the function after a property that matches has changed: "
         "watch(\"world.*.velocity\", handler)."},
        {"who", "who(path: string)",
         "Prints what wrote a property last, and at which step: \"console:1, step 49\"; for the "
         "path of an instance, what wrote each of its properties. After "
         "going back in time, that is the last write before that moment, or \"restore, step 30\" "
         "if none is known. The file and line of a script are known if the property was watched "
         "when it was written; "
         "otherwise only \"script\" is printed. For a value that the simulation changes, the "
         "last other writer is printed; the simulation is printed only if there is no other "
         "writer or the property is watched."},
        {"why", "why(path: string)",
         "Explains where the value of a property comes from: its formula, and the properties "
         "that it reads."},
    };
    return docs;
}

const std::vector<GlobalDoc>& variable_docs() {
    static const std::vector<GlobalDoc> docs = {
        {"_", "any", "The result of the console's last command."},
        {"_G", "table", "The table of all globals."},
        {"_VERSION", "string", "The version of Lua."},
        {"classes", "Class[]",
         "All classes, by number and by name: classes.Body.properties. Read-only."},
        {"game", "Game", "The root of the tree."},
        {"it", "Object", "In the console: the instance that is selected."},
        {"store", "Store", "Values that outlive the run: store.best = 100."},
    };
    return docs;
}

const std::vector<GlobalDoc>& callback_docs() {
    static const std::vector<GlobalDoc> docs = {
        {"start", "start()", "Called once, when main.lua has run."},
        {"update", "update(dt: number, real_dt: number)",
         "Called every frame; dt is the game time since the last one in seconds: real time times "
         "time.scale, 0 while the game is paused. real_dt is the real time, also while the game is "
         "paused; in a headless run, one step."},
        {"step", "step(dt: number)",
         "Called before every fixed step of the simulation, time.dt seconds long."},
        {"draw", "draw(pen: Pen)",
         "Called for every picture, after the instances that draw themselves."},
        {"draw_behind", "draw_behind(pen: Pen)",
         "Called for every picture, before everything else that is drawn."},
        {"key_pressed", "key_pressed(key: string)", "A key went down: \"space\", \"a\", \"left\"."},
        {"key_released", "key_released(key: string)", "A key came up."},
        {"text_input", "text_input(text: string)", "A character was typed, by one key or several."},
        {"mouse_pressed", "mouse_pressed(button: string, position: vec, screen: vec)",
         "A button went down, at a position in the world and on the screen in pixels."},
        {"mouse_released", "mouse_released(button: string, position: vec, screen: vec)",
         "A button came up, at a position in the world and on the screen in pixels."},
        {"mouse_moved", "mouse_moved(position: vec, screen: vec)",
         "The mouse moved to a position in the world and on the screen in pixels."},
        {"wheel", "wheel(notches: number, position: vec)",
         "The wheel was turned, away from the user positive, over a position in the world."},
        {"gamepad_pressed", "gamepad_pressed(gamepad: integer, button: string)",
         "A button of a gamepad went down; gamepads are counted from 1, and buttons are called "
         "\"1\" to \"16\". A button with a name calls it twice, with the number and with the name: "
         "\"a\", \"left_shoulder\", \"dpad_up\"."},
        {"gamepad_released", "gamepad_released(gamepad: integer, button: string)",
         "A button of a gamepad came up."},
        {"gamepad_axis", "gamepad_axis(gamepad: integer, axis: string, value: number)",
         "An axis of a gamepad moved: \"left_x\", \"left_y\", \"right_x\", \"right_y\", "
         "\"pad_x\" or \"pad_y\" to a value from -1 to 1, right and up positive; "
         "\"left_trigger\" or \"right_trigger\" to a value from 0 to 1."},
        {"action_pressed", "action_pressed(action: string)",
         "The player began to hold an action: one of its keys or buttons in input.actions went "
         "down."},
        {"action_released", "action_released(action: string)", "The player let go of an action."},
        {"resized", "resized(width: number, height: number)",
         "The window got another size, in pixels."},
        {"focus", "focus(focused: boolean)", "The window got the keyboard, or lost it."},
        {"enter", "enter(args: any)",
         "The scene that go_to_scene named is now game.scene; args are those of the call. Not "
         "called "
         "if the class of the scene has a function of that name."},
        {"leave", "leave()",
         "The scene is about to be replaced and still complete. Not called if the class of the "
         "scene "
         "has a function of that name."},
        {"reloaded", "reloaded(files: string[])",
         "Files of the game have changed while it runs, and the game uses them now; start() is not "
         "called again."},
        {"closing", "closing()",
         "The run is about to end: its window is closed, or a signal (Ctrl+C, SIGTERM) was "
         "received. quit() and the end of --steps do not call it. After it no update and no "
         "draw is called; watchers and handlers of events are still called for what it changed. "
         "After a "
         "signal it may take five seconds."},
    };
    return docs;
}

const std::vector<GlobalDoc>& class_callback_docs() {
    static const std::vector<GlobalDoc> docs = {
        {"ready", "ready(self: Object)",
         "Called when the instance has found its place in the tree, children first."},
        {"step", "step(self: Object, dt: number)",
         "Called before every fixed step of the simulation, time.dt seconds long."},
        {"draw", "draw(self: Object, pen: Pen)",
         "Called for every picture, at the place of the instance in the order of z."},
        {"enter", "enter(self: Object, args: any)",
         "The instance is now game.scene; args are those of go_to_scene."},
        {"leave", "leave(self: Object)", "The instance is game.scene and about to be replaced."},
    };
    return docs;
}

namespace {

std::vector<std::string> names_of(const std::vector<GlobalDoc>& docs) {
    std::vector<std::string> names;
    names.reserve(docs.size());
    for (const GlobalDoc& doc : docs) names.emplace_back(doc.name);
    return names;
}

}  // namespace

const std::vector<std::string>& callback_names() {
    static const std::vector<std::string> names = names_of(callback_docs());
    return names;
}

const std::vector<std::string>& generic_names() {
    static const std::vector<std::string> names = names_of(instance_docs());
    return names;
}

const GlobalDoc* global_doc(std::string_view name) {
    for (const auto* docs : {&global_docs(), &library_docs(), &variable_docs(), &callback_docs()})
        for (const GlobalDoc& doc : *docs)
            if (name == doc.name) return &doc;
    return nullptr;
}

std::string shown_name(const GlobalDoc& doc) {
    return std::string_view(doc.signature).find('(') == std::string_view::npos
               ? doc.name
               : plain_signatures(doc.signature);
}

bool MemberDoc::is_function() const {
    const std::size_t length = std::strlen(name);
    return std::strncmp(signature, name, length) == 0 && signature[length] == '(';
}

const TypeDoc* type_doc(std::string_view name) {
    for (const TypeDoc& doc : type_docs())
        if (name == doc.name) return &doc;
    return nullptr;
}

}  // namespace fettle::script
