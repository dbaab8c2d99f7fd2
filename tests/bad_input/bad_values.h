// What is passed for a parameter of each type. The first value is a good one, which the other parameters have
// while one is bad.
#pragma once

#include "bad_scene.h"

#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace bad_input {

template <class T>
struct Value {
    std::string name;
    T value;
};

// Large enough for what any function reads or writes beside arrays whose length is an argument.
constexpr std::size_t kBlock = 1 << 16;

// `first` is the good one.
template <class T>
std::vector<Value<T>> valuesOf(const std::string &kind, const std::vector<T> &objects, std::size_t first) {
    std::vector<Value<T>> values{{kind + std::to_string(first), objects[first]}, {"NULL", nullptr}};
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (i != first) values.push_back({kind + std::to_string(i), objects[i]});
    return values;
}

// One for each number; calls may write to them: each call is made in a process of its own.
double *blockOfDoubles(double value);

template <class T>
T *blockOf(double value) {
    return reinterpret_cast<T *>(blockOfDoubles(value));
}

template <class T, class = void>
struct Values;

template <>
struct Values<dWorldID> {
    static auto all(const std::string &) { return valuesOf("world", std::vector<dWorldID>{scene->world}, 0); }
};
template <>
struct Values<dBodyID> {
    static auto all(const std::string &) { return valuesOf("body", scene->bodies, 0); }
};
// A space is a geom, and may be passed as one; and a geom that is none where a space is asked for.
template <>
struct Values<dGeomID> {
    static auto all(const std::string &function) {
        auto values = valuesOf("geom", scene->geoms, scene->geomFor(function));
        for (std::size_t i = 0; i < scene->spaces.size(); ++i)
            values.push_back({"space" + std::to_string(i), reinterpret_cast<dGeomID>(scene->spaces[i])});
        return values;
    }
};
template <>
struct Values<dSpaceID> {
    static auto all(const std::string &function) {
        const bool isQuad = function.find("QuadTree") != std::string::npos,
                   isHash = function.find("Hash") != std::string::npos;
        auto values = valuesOf("space", scene->spaces, isQuad ? 3 : isHash ? 1 : 0);
        values.push_back({"geom0", reinterpret_cast<dSpaceID>(scene->geoms[0])});
        return values;
    }
};
template <>
struct Values<dJointID> {
    static auto all(const std::string &function) {
        return valuesOf("joint", scene->joints, scene->jointFor(function));
    }
};
template <>
struct Values<dJointGroupID> {
    static auto all(const std::string &) {
        return valuesOf("group", std::vector<dJointGroupID>{scene->group}, 0);
    }
};
template <>
struct Values<dTriMeshDataID> {
    static auto all(const std::string &) {
        return valuesOf("mesh", std::vector<dTriMeshDataID>{scene->mesh, scene->emptyMesh}, 0);
    }
};
template <>
struct Values<dHeightfieldDataID> {
    static auto all(const std::string &) {
        return valuesOf("heights", std::vector<dHeightfieldDataID>{scene->heights, scene->emptyHeights}, 0);
    }
};
template <>
struct Values<dMass *> {
    static auto all(const std::string &) {
        return std::vector<Value<dMass *>>{
            {"mass", &scene->mass},
            {"NULL", nullptr},
            {"zeros", blockOf<dMass>(0)},
            {"NaNs", blockOf<dMass>(std::numeric_limits<double>::quiet_NaN())}};
    }
};
template <>
struct Values<const dMass *> {
    static auto all(const std::string &function) {
        std::vector<Value<const dMass *>> values;
        for (const auto &value : Values<dMass *>::all(function)) values.push_back({value.name, value.value});
        return values;
    }
};
template <>
struct Values<const char *> {
    static auto all(const std::string &function) {
        std::vector<Value<const char *>> values{{"text", "x"}, {"NULL", nullptr}, {"nothing", ""}, {"format", "%s%n"}};
        if (function == "dODE_MT_StepWorlds") values.insert(values.begin(), {"quick", "quick"});
        return values;
    }
};
// A list of one world; in a longer one it stands twice.
template <>
struct Values<const dWorldID *> {
    static auto all(const std::string &) {
        static const dWorldID worlds[] = {scene->world, scene->world}, none[] = {nullptr, nullptr};
        return std::vector<Value<const dWorldID *>>{{"worlds", worlds}, {"NULL", nullptr}, {"zeros", none}};
    }
};

template <class Number>
struct Values<Number, std::enable_if_t<std::is_floating_point_v<Number>>> {
    static auto all(const std::string &) {
        using Limits = std::numeric_limits<Number>;
        return std::vector<Value<Number>>{{"0.5", Number(0.5)},
                                          {"0", 0},
                                          {"-1", -1},
                                          {"huge", Number(1e30)},
                                          {"denormal", Limits::denorm_min()},
                                          {"inf", Limits::infinity()},
                                          {"-inf", -Limits::infinity()},
                                          {"nan", Limits::quiet_NaN()}};
    }
};
template <class Number>
struct Values<Number, std::enable_if_t<std::is_integral_v<Number>>> {
    static auto all(const std::string &) {
        using Limits = std::numeric_limits<Number>;
        return std::vector<Value<Number>>{{"1", 1},
                                          {"0", 0},
                                          {"-1", static_cast<Number>(-1)},
                                          {"7", 7},
                                          {"256", static_cast<Number>(256)},
                                          {"largest", Limits::max()},
                                          {"smallest", Limits::min()}};
    }
};
template <class Enum>
struct Values<Enum, std::enable_if_t<std::is_enum_v<Enum>>> {
    static auto all(const std::string &) {
        return std::vector<Value<Enum>>{{"0", Enum(0)}, {"1", Enum(1)}, {"99", Enum(99)}};
    }
};
template <class Result, class... Types>
struct Values<Result (*)(Types...)> {
    static Result nothing(Types...) {
        if constexpr (!std::is_void_v<Result>) return Result{};
    }
    static auto all(const std::string &) {
        return std::vector<Value<Result (*)(Types...)>>{{"function", nothing}, {"NULL", nullptr}};
    }
};
// Arrays, structures and places for results.
template <class T>
struct Values<T *, std::enable_if_t<!std::is_function_v<T>>> {
    static auto all(const std::string &) {
        using Plain = std::remove_const_t<T>;
        return std::vector<Value<T *>>{{"ones", blockOf<Plain>(1)},
                                       {"NULL", nullptr},
                                       {"zeros", blockOf<Plain>(0)},
                                       {"infs", blockOf<Plain>(std::numeric_limits<double>::infinity())},
                                       {"NaNs", blockOf<Plain>(std::numeric_limits<double>::quiet_NaN())}};
    }
};

}  // namespace bad_input
