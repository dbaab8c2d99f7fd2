// Makes a Function of a function of ODE's: its parameters follow from its type, their meaning from its name.
#pragma once

#include "function.h"
#include "player.h"

#include <ode/ode.h>

#include <type_traits>
#include <utility>

namespace fuzz {

Meaning meaningOf(const std::string &function);
int typeOf(const std::string &function, ObjectKind kind);  // of the geom or joint that a function is for
bool isParameterNumber(const std::string &function);  // its whole number is one of dParamLoStop and so on
bool isLevel(const std::string &function);            // its whole numbers are powers of two: the sizes of a hash space's cells
int lengthOf(const std::string &function);                 // of an array that is read

// How a parameter of each type is drawn, and an argument passed. `In` lives as long as the call.
template <class T, class = void>
struct Passing;

template <ObjectKind kind_, class Handle>
struct PassingObject {
    static Parameter parameter(const std::string &function) {
        Parameter parameter;
        parameter.kind = Parameter::Kind::object;
        parameter.object = kind_;
        parameter.type = typeOf(function, kind_);
        return parameter;
    }
    struct In {
        Handle value;
        bool isThere;
        In(const Player &player, const Argument &argument)
            : value(static_cast<Handle>(player.find(argument))), isThere(value != nullptr || argument.reference.number < 0) {}
        Handle get() { return value; }
    };
    static constexpr bool isOut = false;
};
template <> struct Passing<dWorldID> : PassingObject<ObjectKind::world, dWorldID> {};
template <> struct Passing<dSpaceID> : PassingObject<ObjectKind::space, dSpaceID> {};
template <> struct Passing<dBodyID> : PassingObject<ObjectKind::body, dBodyID> {};
template <> struct Passing<dGeomID> : PassingObject<ObjectKind::geom, dGeomID> {};
template <> struct Passing<dJointID> : PassingObject<ObjectKind::joint, dJointID> {};
template <> struct Passing<dJointGroupID> : PassingObject<ObjectKind::group, dJointGroupID> {};
template <> struct Passing<dTriMeshDataID> : PassingObject<ObjectKind::meshData, dTriMeshDataID> {};
template <> struct Passing<dHeightfieldDataID> : PassingObject<ObjectKind::heightData, dHeightfieldDataID> {};

template <class Number>
struct Passing<Number, std::enable_if_t<std::is_arithmetic_v<Number>>> {
    static Parameter parameter(const std::string &function) {
        Parameter parameter;
        parameter.meaning = std::is_floating_point_v<Number> ? meaningOf(function)
                            : std::is_same_v<Number, unsigned long> ? Meaning::bits
                            : isParameterNumber(function)             ? Meaning::parameter
                            : isLevel(function)                       ? Meaning::level
                                                                      : Meaning::count;
        return parameter;
    }
    struct In {
        Number value;
        bool isThere = true;
        // What does not fit is a script's that was written by hand.
        In(const Player &, const Argument &argument) : value(convert(argument.numbers.at(0))) {}
        Number get() { return value; }
        static Number convert(double number) {
            if constexpr (std::is_floating_point_v<Number>)
                return static_cast<Number>(number);
            else
                return static_cast<Number>(static_cast<long long>(number));
        }
    };
    static constexpr bool isOut = false;
};

// An array that is read.
template <>
struct Passing<const dReal *> {
    static Parameter parameter(const std::string &function) {
        Parameter parameter;
        parameter.kind = Parameter::Kind::numbers;
        parameter.meaning = meaningOf(function);
        parameter.length = lengthOf(function);
        parameter.isPose = parameter.length != 3;
        return parameter;
    }
    struct In {
        dReal values[16] = {};
        bool isThere = true;
        In(const Player &, const Argument &argument) {
            for (std::size_t i = 0; i < argument.numbers.size() && i < 16; ++i) values[i] = static_cast<dReal>(argument.numbers[i]);
        }
        const dReal *get() { return values; }
    };
    static constexpr bool isOut = false;
};

// A place for results: no argument of the script's.
template <>
struct Passing<dReal *> {
    struct In {
        dReal values[16] = {};
        bool isThere = true;
        In() = default;
        dReal *get() { return values; }
    };
    static constexpr bool isOut = true;
};

template <class T>
struct ObjectKindOf;
template <> struct ObjectKindOf<dWorldID> { static constexpr ObjectKind kind = ObjectKind::world; };
template <> struct ObjectKindOf<dSpaceID> { static constexpr ObjectKind kind = ObjectKind::space; };
template <> struct ObjectKindOf<dBodyID> { static constexpr ObjectKind kind = ObjectKind::body; };
template <> struct ObjectKindOf<dGeomID> { static constexpr ObjectKind kind = ObjectKind::geom; };
template <> struct ObjectKindOf<dJointID> { static constexpr ObjectKind kind = ObjectKind::joint; };
template <> struct ObjectKindOf<dJointGroupID> { static constexpr ObjectKind kind = ObjectKind::group; };

template <class Result>
void tellResult(Player &player, Result result) {
    if constexpr (std::is_arithmetic_v<Result>) {
        const double value = static_cast<double>(result);
        player.tell("returns", &value, 1);
    } else if constexpr (std::is_same_v<Result, const dReal *>) {
        if (result == nullptr) return player.tell("returns nothing", nullptr, 0);
        const double values[3] = {result[0], result[1], result[2]};
        player.tell("returns", values, 3);
    } else {
        player.trace().object(result);
    }
}

template <class Result, class... Types, std::size_t... places>
Function typed(const char *name, Result (*function)(Types...), std::index_sequence<places...>) {
    Function made;
    made.name = name;
    [[maybe_unused]] const auto addParameter = [&](auto passing) {
        if constexpr (!decltype(passing)::isOut) made.parameters.push_back(passing.parameter(made.name));
    };
    (addParameter(Passing<Types>()), ...);
    made.call = [function](Player &player, const Arguments &arguments, Reference &) {
        std::size_t next = 0;
        [[maybe_unused]] const auto pass = [&](auto passing) {
            using P = decltype(passing);
            if constexpr (P::isOut)
                return typename P::In();
            else
                return typename P::In(player, arguments.at(next++));
        };
        std::tuple<typename Passing<Types>::In...> in{pass(Passing<Types>())...};
        if (!(std::get<places>(in).isThere && ...)) return false;
        if constexpr (std::is_void_v<Result>)
            function(std::get<places>(in).get()...);
        else
            tellResult(player, function(std::get<places>(in).get()...));
        [[maybe_unused]] const auto tellOut = [&](auto passing, auto &value) {
            if constexpr (decltype(passing)::isOut) {
                const std::vector<double> values(value.values, value.values + 16);
                player.tell("gives", values.data(), 16);
            }
        };
        (tellOut(Passing<Types>(), std::get<places>(in)), ...);
        return true;
    };
    return made;
}

template <class Result, class... Types>
Function typed(const char *name, Result (*function)(Types...)) {
    return typed(name, function, std::index_sequence_for<Types...>());
}

// One that makes an object.
template <class Result, class... Types, std::size_t... places>
Function maker(const char *name, Result (*function)(Types...), std::index_sequence<places...>) {
    Function made = typed(name, function);
    made.isMaker = true;
    made.makes = ObjectKindOf<Result>::kind;
    for (Parameter &parameter : made.parameters)
        if (parameter.kind == Parameter::Kind::object && (parameter.object == ObjectKind::space || parameter.object == ObjectKind::group))
            parameter.kind = Parameter::Kind::nullableObject;
    made.call = [function](Player &player, const Arguments &arguments, Reference &result) {
        std::tuple<typename Passing<Types>::In...> in{typename Passing<Types>::In(player, arguments.at(places))...};
        if (!(std::get<places>(in).isThere && ...)) return false;
        const Result object = function(std::get<places>(in).get()...);
        player.adopt(ObjectKindOf<Result>::kind, object, result);
        if constexpr (std::is_same_v<Result, dJointID>)
            player.objects.putJoint(object, std::get<0>(in).get(), std::get<1>(in).get());
        return true;
    };
    return made;
}

template <class Result, class... Types>
Function maker(const char *name, Result (*function)(Types...)) {
    return maker(name, function, std::index_sequence_for<Types...>());
}

}  // namespace fuzz

#define FUZZ_TYPED(function) all.push_back(::fuzz::typed(#function, function))
#define FUZZ_MAKER(function) all.push_back(::fuzz::maker(#function, function))
