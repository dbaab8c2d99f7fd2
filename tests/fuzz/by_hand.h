// Functions whose calls are written by hand: their types do not say what they take.
#pragma once

#include "typed.h"

namespace fuzz {

inline Parameter object(ObjectKind kind, int type = -1) {
    Parameter parameter;
    parameter.kind = Parameter::Kind::object;
    parameter.object = kind;
    parameter.type = type;
    return parameter;
}

inline Parameter nullable(ObjectKind kind) {
    Parameter parameter = object(kind);
    parameter.kind = Parameter::Kind::nullableObject;
    return parameter;
}

inline Parameter word(std::vector<std::string> words) {
    Parameter parameter;
    parameter.kind = Parameter::Kind::word;
    parameter.words = std::move(words);
    return parameter;
}

inline Parameter number(Meaning meaning) {
    Parameter parameter;
    parameter.meaning = meaning;
    return parameter;
}

template <class Handle>
Handle get(const Player &player, const Argument &argument) {
    return static_cast<Handle>(player.find(argument));
}

inline int whole(const Argument &argument) { return static_cast<int>(static_cast<long long>(argument.numbers.at(0))); }
inline dReal real(const Argument &argument) { return static_cast<dReal>(argument.numbers.at(0)); }

inline Function &byHand(std::vector<Function> &all, const char *name, std::vector<Parameter> parameters, decltype(Function::call) call,
                        int weight = 4) {
    Function made;
    made.name = name;
    made.parameters = std::move(parameters);
    made.call = std::move(call);
    made.weights[0] = weight;
    all.push_back(std::move(made));
    return all.back();
}

inline Function &byHandMaker(std::vector<Function> &all, const char *name, ObjectKind makes, std::vector<Parameter> parameters,
                             decltype(Function::call) call, int weight = 4) {
    Function &made = byHand(all, name, std::move(parameters), std::move(call), weight);
    made.isMaker = true;
    made.makes = makes;
    return made;
}

// The program's pointer that an object has; here a number.
template <class Handle>
void addData(std::vector<Function> &all, ObjectKind kind, const char *setter, void (*set)(Handle, void *), const char *getter,
             void *(*read)(Handle)) {
    byHand(all, setter, {object(kind), number(Meaning::bits)}, [set](Player &player, const Arguments &arguments, Reference &) {
        const auto handle = get<Handle>(player, arguments[0]);
        if (handle == nullptr) return false;
        set(handle, reinterpret_cast<void *>(static_cast<std::intptr_t>(whole(arguments[1]))));
        return true;
    }, 1);
    byHand(all, getter, {object(kind)}, [read](Player &player, const Arguments &arguments, Reference &) {
        const auto handle = get<Handle>(player, arguments[0]);
        if (handle == nullptr) return false;
        const auto value = static_cast<double>(reinterpret_cast<std::intptr_t>(read(handle)));
        player.tell("returns", &value, 1);
        return true;
    }, 1);
}

}  // namespace fuzz
