// A module in C++ whose callbacks throw: the one that the property `fails` names. "exit", "crash",
// "recurse", "hang": the next step ends the process, writes to memory that is not there, calls
// itself without end, or never ends.

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fettle/module/guest.h>

using namespace fettle;
using property::Handle;
using property::Native;
using property::Row;
using property::Tree;
using property::Type;
using property::Value;

namespace {

class Thrower : public module::Module {
  public:
    std::string_view name() const override { return "thrower"; }

    void attach(Tree& tree) override {
        property::ClassDescriptor fragile;
        fragile.name = "Fragile";
        fragile.properties = {
            {.name = "fails",
             .type = Type::text,
             .binding = property::accessor(
                 *this, [](Thrower& m, Row) { return Value(m.fails_); },
                 [](Thrower& m, Row, const Value& value) { m.fails_ = value.text(); }),
             .transient = true},
            {.name = "of_no_class",  // throws an int in place of a std::runtime_error
             .type = Type::boolean,
             .default_value = false,
             .binding = property::accessor(
                 *this, [](Thrower& m, Row) { return Value(m.of_no_class_); },
                 [](Thrower& m, Row, const Value& value) { m.of_no_class_ = value.boolean(); }),
             .transient = true},
            {.name = "weight",
             .binding = column(*this, Native::f64, 8,
                               [](Thrower& m) {
                                   m.fail("base");
                                   return m.weights_.data();
                               })},
            {.name = "rows", .type = Type::list, .element = Type::list}};
        fragile.methods = {
            {.name = "measure",
             .parameters = {{.name = "from", .type = Type::reference, .reference_class = "Fragile"},
                            {.name = "at", .type = Type::list, .element = Type::number}},
             .call = [](void*, Tree&, Handle, Row, std::span<const Value>) -> property::Result {
                 return Value();
             }}};
        fragile.lifecycle = {.context = this,
                             .create = [](void* m, Tree&, Handle) -> Row {
                                 auto& weights = static_cast<Thrower*>(m)->weights_;
                                 weights.push_back(1);
                                 return weights.size() - 1;
                             },
                             .destroy = [](void* m, Tree&, Handle,
                                           Row) { static_cast<Thrower*>(m)->fail("destroy"); }};
        tree.define(std::move(fragile));
        tree.add_part(*this);
    }
    void step(double) override {
        if (fails_ == "exit") std::exit(0);
        if (fails_ == "crash") *nowhere = 1;
        if (fails_ == "recurse") (void)depth(1);
        while (fails_ == "hang") *nowhere_else = 1;
        fail("step");
    }
    void report(Tree&) override { fail("report"); }
    std::uint64_t hash() const override {
        fail("hash");
        return 7;
    }
    property::Memory save(property::ByteWriter&) const override {
        fail("save");
        return {};
    }
    std::function<void()> restore(property::ByteReader&, const property::Memory&) override {
        fail("restore");
        return [this] { fail("finish"); };
    }

  private:
    void fail(const std::string& callback) const {
        if (fails_ != callback) return;
        if (of_no_class_) throw 42;
        throw std::runtime_error("no " + callback + " today");
    }

    static int depth(int level) {
        volatile char room[4096];
        room[0] = static_cast<char>(level);
        return level == 0 ? 0 : depth(level + 1) + room[0];
    }

    static inline volatile int* volatile nowhere = nullptr;
    static inline volatile int somewhere = 0;
    static inline volatile int* volatile nowhere_else = &somewhere;

    std::string fails_;
    bool of_no_class_ = false;
    std::vector<double> weights_;
};

}  // namespace

FETTLE_GUEST(Thrower, "1.0")
