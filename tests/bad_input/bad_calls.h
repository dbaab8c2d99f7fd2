// Calls of functions with one bad argument at a time.
#pragma once

#include "bad_values.h"

#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bad_input {

struct BadCall {
    std::string name;  // "dBodySetMass(body0, NULL)"
    std::function<void()> make;
};

template <class Result, class... Types, std::size_t... places>
void addCalls(std::vector<BadCall> &calls, const char *name, Result (*function)(Types...),
              std::index_sequence<places...>) {
    const auto values = std::make_tuple(Values<Types>::all(name)...);
    const auto add = [&](std::size_t bad, std::size_t which) {
        std::string text;
        [[maybe_unused]] const auto select = [&](const auto &ofType, std::size_t place) {
            const auto &value = ofType[place == bad ? which : 0];
            text += (text.empty() ? "" : ", ") + value.name;
            return value.value;
        };
        // In braces, so that they are selected in their order.
        const std::tuple<Types...> arguments{select(std::get<places>(values), places)...};
        calls.push_back({std::string(name) + '(' + text + ')', [=] { std::apply(function, arguments); }});
    };
    constexpr std::size_t kNone = sizeof...(Types);
    add(kNone, 0);
    [[maybe_unused]] const auto addBad = [&](const auto &ofType, std::size_t place) {
        for (std::size_t which = 1; which < ofType.size(); ++which) add(place, which);
    };
    (addBad(std::get<places>(values), places), ...);
}

template <class Result, class... Types>
void addCalls(std::vector<BadCall> &calls, const char *name, Result (*function)(Types...)) {
    addCalls(calls, name, function, std::index_sequence_for<Types...>());
}

// Defined by the list of functions that the program was built with.
std::vector<BadCall> badCalls();

}  // namespace bad_input
