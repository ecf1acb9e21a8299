#include <functional>
#include <memory>
#include <string>

#include <fettle/property/edits.h>
#include <fettle/property/observer.h>
#include <fettle/property/pinned.h>

#include "catch.h"
#include "fixture.h"
#include "last_words.h"

namespace pinned_test {

// Functions called inside an operation of the tree that destroy the tree: the program is ended with
// a message that names the function.

using namespace fettle::property;

namespace {

std::unique_ptr<Tree> tree;

const Class& with(const std::function<void(ClassDescriptor&)>& spoil) {
    ClassDescriptor of{.name = "X"};
    spoil(of);
    return tree->define(std::move(of));
}

}  // namespace

TEST_CASE(
    "destroying the tree inside one of its operations ends the program with the name of the "
    "function") {
    const auto ends = [](const char* who, const std::function<void()>& act) {
        INFO(who);
        tree = std::make_unique<Tree>();
        CHECK_THAT(termination_message(act),
                   contains(std::string("the tree is destroyed by ") + who));
    };
    ends("the function given to mark_weight", [] {
        tree->mark_weight(tree->weight(), [] { tree.reset(); });
        tree->create(tree->object_class());
    });
    ends("the function given to each_below",
         [] { tree->each_below(tree->root(), [](Handle) { tree.reset(); }); });
    ends("what restores a snapshot", [] {
        const Snapshot snapshot = tree->snapshot();
        tree->restore(snapshot, [] { tree.reset(); });
    });
    ends("an observer", [] {
        struct O : Observer {
            void created(Handle) override { tree.reset(); }
        } observer;
        tree->observe(observer);
        tree->create(tree->object_class());
    });
    struct E : EditObserver {
        void instance_created(Handle) override { tree.reset(); }
        void instance_deleting(Handle) override { tree.reset(); }
        void moved(Handle, Handle, const std::string&) override { tree.reset(); }
    };
    const auto ends_edit = [&](const std::function<void(Handle)>& act) {
        ends("an observer of edits", [&] {
            const Handle there = tree->create(tree->object_class(), tree->root());
            static E observer;
            tree->observe_edits(&observer);
            const Tree::CauseScope person(*tree, Writer::console);
            act(there);
        });
    };
    ends_edit([](Handle) { tree->create(tree->object_class()); });
    ends_edit([](Handle there) { tree->destroy(there); });
    ends_edit([](Handle there) { tree->rename(there, "other"); });
    ends("a lifecycle function", [] {
        tree->create(with([](auto& of) {
            of.lifecycle.create = [](void*, Tree&, Handle) -> Row {
                tree.reset();
                return 0;
            };
        }));
    });
    ends("a lifecycle function", [] {
        tree->destroy(tree->create(with([](auto& of) {
            of.lifecycle.destroy = [](void*, Tree&, Handle, Row) { tree.reset(); };
        })));
    });
    ends("a binding of a property", [] {
        const Handle x = tree->create(with([](auto& of) {
            Property v{.name = "v", .type = Type::text};
            v.binding.kind = BindingKind::accessor;
            v.binding.get = [](void*, Row) -> Value { return "a"; };
            v.binding.set = [](void*, Row, const Value&) { tree.reset(); };
            of.properties = {v};
        }));
        tree->set(x, "v", "b");
    });
    ends("the function given to on_print", [] {
        const Pinned pinned(*tree, "the function given to on_print");
        tree.reset();
    });
    tree.reset();
}

}  // namespace pinned_test
