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
    made.inNear = isAllowed(name, Where::near);
    made.inMoved = isAllowed(name, Where::moved);
    made.weight = weight;
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

}  // namespace fuzz
