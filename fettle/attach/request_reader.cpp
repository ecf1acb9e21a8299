// Reads a request without building it in memory: lines come from any program that has the token.

#include <attach/protocol.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace fettle::program {
namespace {

using Json = nlohmann::json;

/// Receives the tokens of one request. A function that returns false ends the reading.
class RequestReader : public nlohmann::json_sax<Json> {
  public:
    /// None if there was neither a command nor the beginning of one, nor a stop.
    std::optional<Request> request() && {
        Request made;
        if (!run_ && !complete_) {
            made.kind = Request::Kind::stop;
            return stop_ ? std::optional(made) : std::nullopt;
        }
        made.kind = run_ ? Request::Kind::run : Request::Kind::complete;
        made.text = std::move(run_ ? *run_ : *complete_);
        made.cursor = std::min(cursor_, made.text.size());
        return made;
    }

    bool null() override { return plain(); }
    bool boolean(bool value) override {
        if (name_ == "stop") stop_ = value;
        return plain();
    }
    bool number_integer(Json::number_integer_t) override { return plain(); }
    bool number_float(Json::number_float_t, const std::string&) override { return plain(); }
    bool number_unsigned(Json::number_unsigned_t value) override {
        if (name_ == "cursor") cursor_ = value;
        return plain();
    }
    bool string(std::string& value) override {
        if (name_ == "run")
            run_ = std::move(value);
        else if (name_ == "complete")
            complete_ = std::move(value);
        return plain();
    }
    bool key(std::string& name) override {
        name_ = std::move(name);
        return ++members_ <= most_members;
    }
    bool start_object(std::size_t) override { return !std::exchange(inside_, true); }
    bool end_object() override { return true; }
    bool start_array(std::size_t) override { return false; }
    bool end_array() override { return false; }
    bool binary(Json::binary_t&) override { return false; }
    bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
        return false;
    }

  private:
    /// A request is an object, so a plain value is one of its members.
    bool plain() const { return inside_; }

    bool inside_ = false;  // the object has begun
    bool stop_ = false;
    std::size_t members_ = 0, cursor_ = 0;
    std::string name_{};  // of the member that is read
    std::optional<std::string> run_{}, complete_{};
};

}  // namespace

std::optional<Request> read_request(std::string_view line) {
    RequestReader reader;
    if (!Json::sax_parse(line.begin(), line.end(), &reader)) return std::nullopt;
    return std::move(reader).request();
}

}  // namespace fettle::program
