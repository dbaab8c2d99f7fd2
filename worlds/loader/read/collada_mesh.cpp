#include "loader/read/collada_mesh.h"

#include "loader/load_error.h"
#include "loader/read/mesh_file.h"
#include "loader/read/word_list.h"
#include "loader/read/xml_text.h"
#include "support/text.h"

#include <algorithm>

namespace worlds {

namespace {

using tinyxml2::XMLElement;

// The largest count whose sums and products do not overflow.
constexpr std::int64_t largestCount = 1 << 30;

const XMLElement &childWithId(const XMLElement &mesh, const char *name, const std::string &id) {
    const XMLElement *found = nullptr;
    for (const XMLElement *child = mesh.FirstChildElement(name); child;
         child = child->NextSiblingElement(name)) {
        if (!child->Attribute("id", id.c_str())) continue;
        if (found) throw MeshFault("two elements have id " + support::quote(id));
        found = child;
    }
    if (!found) throw MeshFault("<mesh> has no <" + std::string(name) + "> with id " + support::quote(id));
    return *found;
}

std::vector<std::size_t> wholeNumbers(const XMLElement &element) {
    std::vector<std::size_t> numbers;
    const std::string text = wholeText(element);
    WordList words(text);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const std::optional<std::int64_t> number = wholeNumber(word);
        if (!number || *number < 0 || *number > largestCount)
            fail(element, "holds " + support::quote(std::string(word)) + ", not a whole number that is not negative");
        numbers.push_back(static_cast<std::size_t>(*number));
    }
    return numbers;
}

void readPositions(const XMLElement &source, ColladaMesh &mesh) {
    const XMLElement &accessor = requiredChild(requiredChild(source, "technique_common"), "accessor");
    const XMLElement &array = requiredChild(source, "float_array");
    const char *const id = array.Attribute("id");
    if (!id || referenceOf(accessor, "source") != id) fail(accessor, "is not of the numbers of its source");

    const std::string text = wholeText(array);
    std::vector<std::string_view> numbers;
    WordList words(text);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (!finiteNumber(word)) fail(array, "holds " + support::quote(std::string(word)) + ", not a finite number");
        numbers.push_back(word);
    }
    if (numbers.size() != countOf(array, "count"))
        fail(array, "holds " + std::to_string(numbers.size()) + " numbers and says that there are " +
                        std::to_string(countOf(array, "count")));

    const std::size_t stride = countOf(accessor, "stride", 1), offset = countOf(accessor, "offset", 0);
    std::size_t places[3] = {stride, stride, stride}, place = 0;
    for (const XMLElement *param = accessor.FirstChildElement("param"); param;
         param = param->NextSiblingElement("param"), ++place) {
        const std::string name = param->Attribute("name") ? param->Attribute("name") : "";
        if (name.size() == 1 && name[0] >= 'X' && name[0] <= 'Z') places[name[0] - 'X'] = place;
    }
    for (const std::size_t axis : places)
        if (axis >= stride) fail(accessor, "has no X, Y and Z within its stride");
    mesh.vertexCount = countOf(accessor, "count");
    if (mesh.vertexCount > 0 && offset + mesh.vertexCount * stride > numbers.size())
        fail(accessor, "needs " + std::to_string(offset + mesh.vertexCount * stride) + " numbers of " +
                           std::to_string(numbers.size()));
    for (std::size_t i = 0; i < mesh.vertexCount; ++i)
        for (const std::size_t axis : places)
            mesh.positions.append(numbers[offset + i * stride + axis]).append(" ");
}

// Polygons and strips of one material.
class Primitive {
public:
    Primitive(const XMLElement &element, ColladaMesh &mesh) : m_element(element), m_mesh(mesh) {
        int vertexInputs = 0;
        for (const XMLElement *input = element.FirstChildElement("input"); input;
             input = input->NextSiblingElement("input")) {
            const std::size_t offset = countOf(*input, "offset");
            m_stride = std::max(m_stride, offset + 1);
            if (!input->Attribute("semantic", "VERTEX")) continue;
            ++vertexInputs;
            m_offset = offset;
            vertices = referenceOf(*input, "source");
        }
        if (vertexInputs != 1)
            fail(element, "has " + std::to_string(vertexInputs) + " inputs VERTEX, not one");
    }

    void read() {
        const std::string kind = m_element.Name();
        const std::size_t count = countOf(m_element, "count");
        if (kind == "triangles") {
            const std::vector<std::uint32_t> corners = cornersOf(requiredChild(m_element, "p"));
            if (corners.size() != 3 * count) wrongCount(corners.size());
            for (std::size_t i = 0; i < corners.size(); i += 3) polygon(corners, i, 3);
        } else if (kind == "polylist") {
            polylist(count);
        } else {
            separate(kind, count);
        }
    }

    std::string vertices;  // the id of <vertices>

private:
    std::vector<std::uint32_t> cornersOf(const XMLElement &p) const {
        const std::vector<std::size_t> numbers = wholeNumbers(p);
        if (numbers.size() % m_stride != 0)
            fail(m_element, "has " + std::to_string(numbers.size()) + " indices, of which " +
                                std::to_string(m_stride) + " belong together");
        std::vector<std::uint32_t> corners;
        for (std::size_t i = m_offset; i < numbers.size(); i += m_stride) {
            if (numbers[i] >= m_mesh.vertexCount)
                fail(m_element, "has a vertex " + std::to_string(numbers[i]) + " of " +
                                    std::to_string(m_mesh.vertexCount));
            corners.push_back(static_cast<std::uint32_t>(numbers[i]));
        }
        return corners;
    }

    void polylist(std::size_t count) {
        const std::vector<std::size_t> sizes = wholeNumbers(requiredChild(m_element, "vcount"));
        if (sizes.size() != count) wrongCount(sizes.size());
        const std::vector<std::uint32_t> corners = cornersOf(requiredChild(m_element, "p"));
        std::size_t at = 0;
        for (const std::size_t size : sizes) {
            if (size > corners.size() - at) wrongCount(corners.size());
            polygon(corners, at, size);
            at += size;
        }
        if (at != corners.size()) wrongCount(corners.size());
    }

    // Kinds with a <p> for each polygon, strip or fan.
    void separate(const std::string &kind, std::size_t count) {
        std::size_t found = 0;
        if (m_element.FirstChildElement("ph")) fail(m_element, "holds polygons with holes: not supported");
        for (const XMLElement *p = m_element.FirstChildElement("p"); p;
             p = p->NextSiblingElement("p"), ++found) {
            const std::vector<std::uint32_t> corners = cornersOf(*p);
            if (corners.size() < 3)
                fail(m_element, "has one of " + std::to_string(corners.size()) + " corners");
            if (kind == "polygons") polygon(corners, 0, corners.size());
            if (kind == "polygons") continue;
            for (std::size_t i = 2; i < corners.size(); ++i) {  // the orientation alternates in a strip
                const std::size_t first = kind == "trifans" ? 0 : i - 2;
                const bool isTurned = kind == "tristrips" && i % 2 == 1;
                triangle(corners[isTurned ? i - 1 : first], corners[isTurned ? first : i - 1], corners[i]);
            }
        }
        if (found != count) wrongCount(found);
    }

    void polygon(const std::vector<std::uint32_t> &corners, std::size_t begin, std::size_t size) {
        if (size > maxCorners)
            fail(m_element, "has a polygon of more than " + std::to_string(maxCorners) + " corners");
        if (size < 3) fail(m_element, "has a polygon of " + std::to_string(size) + " corners");
        m_mesh.sizes.push_back(size);
        const auto first = corners.begin() + static_cast<std::ptrdiff_t>(begin);
        m_mesh.corners.insert(m_mesh.corners.end(), first, first + static_cast<std::ptrdiff_t>(size));
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { polygon({a, b, c}, 0, 3); }

    [[noreturn]] void wrongCount(std::size_t found) const {
        fail(m_element, "holds another number than it says: " + std::to_string(found));
    }

    const XMLElement &m_element;
    ColladaMesh &m_mesh;
    std::size_t m_stride = 0, m_offset = 0;
};

bool isPolygonal(const std::string &kind) {
    return kind == "triangles" || kind == "polylist" || kind == "polygons" || kind == "tristrips" ||
           kind == "trifans";
}

}  // namespace

void fail(const XMLElement &element, const std::string &what) { throw MeshFault(shownElement(element) + " " + what); }

std::string shownElement(const XMLElement &element) {
    return "<" + std::string(element.Name()) + "> in line " + std::to_string(element.GetLineNum());
}

const XMLElement &requiredChild(const XMLElement &element, const char *name) {
    const XMLElement *const child = element.FirstChildElement(name);
    if (!child) fail(element, "needs an element <" + std::string(name) + ">");
    if (child->NextSiblingElement(name)) fail(element, "holds two elements <" + std::string(name) + ">");
    return *child;
}

std::size_t countOf(const XMLElement &element, const char *attribute) {
    const char *const value = element.Attribute(attribute);
    if (!value) fail(element, "needs an attribute '" + std::string(attribute) + "'");
    const std::optional<std::int64_t> number = wholeNumber(value);
    if (!number || *number < 0 || *number > largestCount)
        fail(element, "has " + support::quote(value) + " as '" + attribute + "', not a whole number up to " +
                          std::to_string(largestCount));
    return static_cast<std::size_t>(*number);
}

std::size_t countOf(const XMLElement &element, const char *attribute, std::size_t otherwise) {
    return element.Attribute(attribute) ? countOf(element, attribute) : otherwise;
}

std::string referenceOf(const XMLElement &element, const char *attribute) {
    const std::string value = element.Attribute(attribute) ? element.Attribute(attribute) : "";
    if (value.size() < 2 || value[0] != '#')
        fail(element,
             "has " + support::quote(value) + " as '" + attribute + "', not the id of an element of this file");
    return value.substr(1);
}

ColladaMesh readColladaMesh(const XMLElement &element) {
    ColladaMesh mesh;
    const XMLElement *vertices = nullptr;
    for (const XMLElement *child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
        if (!isPolygonal(child->Name())) continue;
        Primitive primitive(*child, mesh);
        const XMLElement &wanted = childWithId(element, "vertices", primitive.vertices);
        if (vertices && vertices != &wanted) fail(element, "has vertices of two kinds: not supported");
        if (!vertices) {
            vertices = &wanted;
            const XMLElement *position = vertices->FirstChildElement("input");
            while (position && !position->Attribute("semantic", "POSITION"))
                position = position->NextSiblingElement("input");
            if (!position) fail(*vertices, "has no input POSITION");
            readPositions(childWithId(element, "source", referenceOf(*position, "source")), mesh);
        }
        primitive.read();
    }
    return mesh;
}

}  // namespace worlds
