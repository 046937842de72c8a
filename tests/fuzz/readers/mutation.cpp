#include "tests/fuzz/readers/mutation.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace weft::fuzz {

namespace {

using Json = nlohmann::json;

constexpr std::string_view blanks = " \t\r\n";

/// Numbers of a malicious file, or of a failed exporter.
std::string odd_word(Random& random) {
    static constexpr std::string_view words[] = {"nan",
                                                 "inf",
                                                 "-inf",
                                                 "1e39",
                                                 "-1e39",
                                                 "1e308",
                                                 "1e400",
                                                 "1e-46",
                                                 "-1",
                                                 "0",
                                                 "-0",
                                                 "1",
                                                 "2",
                                                 "0.5",
                                                 "255",
                                                 "65535",
                                                 "4294967295",
                                                 "2147483648",
                                                 "1e9",
                                                 "-2147483649",
                                                 "999999",
                                                 "1e6",
                                                 "1e5",
                                                 "9223372036854775808",
                                                 "18446744073709551616",
                                                 "+1",
                                                 "1/2/3/4",
                                                 "//",
                                                 "{",
                                                 "}",
                                                 "x",
                                                 ""};
    return std::string(words[random.below(std::size(words))]);
}

Json odd_value(Random& random) {
    switch (random.below(12)) {
        case 0:
            return nullptr;
        case 1:
            return random.chance(0.5);
        case 2:
            return "";
        case 3:
            return "x";
        case 4:
            return Json::array();
        case 5:
            return Json::object();
        case 6:
            return std::string(random.below(300), 'a');
        default:
            return random.one_of<double>({-1,
                                          0,
                                          0.5,
                                          1,
                                          2,
                                          255,
                                          65536,
                                          1e9,
                                          4294967295.0,
                                          4294967296.0,
                                          9007199254740992.0,
                                          1.8446744073709552e19,
                                          1e39,
                                          -1e39,
                                          1e308,
                                          1e-300,
                                          1e5,
                                          1e6,
                                          5121,
                                          5126});
    }
}

/// All values below this one, each with what holds it.
struct JsonPlace {
    Json* holder;
    Json* value;
};
void collect(Json& json, std::vector<JsonPlace>& places) {
    for (Json& each : json) {
        if (!json.is_structured()) return;
        places.push_back({&json, &each});
        collect(each, places);
    }
}

void erase(const JsonPlace& place) {
    for (auto at = place.holder->begin(); at != place.holder->end(); ++at)
        if (&*at == place.value) {
            place.holder->erase(at);
            return;
        }
}

void mutate(Random& random, Json& json) {
    std::vector<JsonPlace> places;
    collect(json, places);
    if (places.empty()) return;
    const JsonPlace place = places[random.below(places.size())];
    switch (random.below(8)) {
        case 0:
            return erase(place);
        case 1:
            if (place.holder->is_array()) place.holder->push_back(Json(*place.value));
            return;
        case 2: {
            Json other = *places[random.below(places.size())].value;
            *place.value = std::move(other);
            return;
        }
        case 3:
            if (place.value->is_number()) {
                *place.value = place.value->get<double>() + random.one_of({-1.0, 1.0, 3.0, 0.25});
                return;
            }
            [[fallthrough]];
        default:
            *place.value = odd_value(random);
    }
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
        lines.push_back(text.substr(at, end + 1 - at));
        at = end + 1;
    }
    return lines;
}

/// Replaces one word of the text by another.
void change_word(Random& random, std::string& text) {
    const std::size_t begin = text.find_first_not_of(blanks, random.below(text.size()));
    if (begin == text.npos) return;
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    text.replace(begin, end - begin, odd_word(random));
}

void change_lines(Random& random, std::string& text) {
    std::vector<std::string> lines = lines_of(text);
    const std::size_t line = random.below(lines.size());
    switch (random.below(3)) {
        case 0:
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line));
            break;
        case 1:
            lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(line), std::string(lines[line]));
            break;
        default:
            std::swap(lines[line], lines[random.below(lines.size())]);
    }
    text.clear();
    for (const std::string& each : lines) text += each;
}

}  // namespace

std::string mutated_bytes(Random& random, std::string bytes) {
    for (std::uint32_t edits = 1 + random.below(3); edits > 0 && !bytes.empty(); --edits) {
        const std::size_t at = random.below(bytes.size());
        const std::size_t count = 1 + random.below(std::min<std::size_t>(bytes.size() - at, 64));
        switch (random.below(6)) {
            case 0:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
                break;
            case 1:
                bytes[at] = static_cast<char>(random.below(256));
                break;
            case 2:
                bytes.erase(at, count);
                break;
            case 3:
                bytes.insert(at, bytes.substr(at, count));
                break;
            case 4:
                bytes.resize(at);
                break;
            default:
                spoil_word(random, std::as_writable_bytes(std::span(bytes)));
        }
    }
    return bytes;
}

std::string mutated_text(Random& random, std::string text) {
    if (random.chance(0.1)) return mutated_bytes(random, std::move(text));
    for (std::uint32_t edits = 1 + random.below(3); edits > 0 && !text.empty(); --edits) {
        if (random.chance(0.7))
            change_word(random, text);
        else
            change_lines(random, text);
    }
    return text;
}

std::string mutated_json(Random& random, Json json) {
    for (std::uint32_t edits = 1 + random.below(3); edits > 0; --edits) mutate(random, json);
    const char* const nest = "nested deeply";
    const bool is_nested = random.chance(0.005);
    if (is_nested) {
        std::vector<JsonPlace> places;
        collect(json, places);
        if (!places.empty()) *places[random.below(places.size())].value = nest;
    }
    std::string text = json.dump();
    if (const std::size_t at = text.find(nest); is_nested && at != text.npos)
        text.replace(at - 1, std::strlen(nest) + 2, std::string(100'000, '[') + std::string(100'000, ']'));
    return random.chance(0.1) ? mutated_bytes(random, std::move(text)) : text;
}

void spoil_word(Random& random, std::span<std::byte> bytes) {
    if (bytes.size() < 4) return;
    const std::size_t at = 4 * random.below(bytes.size() / 4);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (random.chance(0.6)) {
        const float value =
            random.one_of({std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 3e38f, -3e38f, 1e20f,
                           -1.0f, 0.0f, 1.0f, 1e6f, 1e-40f, 1e5f, 17.0f});
        std::memcpy(bytes.data() + at, &value, sizeof value);
    } else {
        const std::uint32_t value = random.one_of({0u, 1u, 2u, 7u, 255u, 65535u, 65536u, 0x7fffffffu,
                                                   0x80000000u, 0xffffffffu, 0x00100000u, 0x10000000u});
        std::memcpy(bytes.data() + at, &value, sizeof value);
    }
}

}  // namespace weft::fuzz
