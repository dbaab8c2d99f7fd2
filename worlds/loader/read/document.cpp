#include "loader/read/document.h"

#include "loader/read/element_check.h"
#include "loader/read/element_path.h"
#include "loader/read/faulty_element.h"
#include "loader/read/source_place.h"
#include "loader/read/source_tree.h"

#include <sdf/Console.hh>
#include <sdf/Exception.hh>
#include <sdf/SDFImpl.hh>
#include <sdf/World.hh>
#include <sdf/parser.hh>

#include <stdexcept>

namespace worlds {

namespace {

LoadError toLoadError(std::string message, const Place &place) {
    message.erase(message.find_last_not_of(" \n") + 1);
    return LoadError(LoadError::Kind::Syntax, place, message);
}

// In reading, libsdformat reports a line, a path, or in words alone what it could not use.
LoadError toLoadError(const sdf::Error &error, const SourceTree &sources) {
    const std::string opened = error.FilePath().value_or("");
    Place place = sources.placeOf(opened, error.LineNumber().value_or(0));
    if (place.path.empty()) place.path = shortPath(error.XmlPath().value_or(""));
    if (place.path.empty()) place = sources.placeNamedIn(error.Message());
    return toLoadError(error.Message(), place);
}

bool isUnknownAttribute(const sdf::Error &error) {
    return error.Code() == sdf::ErrorCode::ATTRIBUTE_INCORRECT_TYPE;
}

sdf::ParserConfig parserConfig() {
    sdf::ParserConfig config;
    config.SetFindCallback([](const std::string &opened) { return opened; });  // found by SourceTree
    config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
    config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);  // named by checkElements
    config.SetDeprecatedElementsPolicy(sdf::EnforcementPolicy::LOG);
    return config;
}

sdf::SDFPtr parse(const SourceTree &sources, const std::string &file, const sdf::ParserConfig &config,
                  const Issues &issues) {
    sdf::SDFPtr document(new sdf::SDF());
    sdf::init(document);
    sdf::Errors errors;
    const bool readable = sdf::readString(sources.text(), config, document->Root(), errors);
    for (const sdf::Error &error : errors) {
        const LoadError asOurs = toLoadError(error, sources);
        if (!isUnknownAttribute(error)) throw asOurs;
        if (readable) issues.unsupported(asOurs.place(), "attribute '" + namesIn(error.Message()).at(0) + "'");
    }
    if (!readable) throw LoadError(LoadError::Kind::Syntax, {file, "/sdf"}, "libsdformat cannot read it");
    return document;
}

// Elements name the files that the user knows from here on.
void nameFiles(const sdf::ElementPtr &element, const SourceTree &sources) {
    element->SetFilePath(sources.nameOf(element->FilePath()));
    for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement())
        nameFiles(child, sources);
}

}  // namespace

Document::Document(const std::string &text, const std::string &file, const ResourceFinder &resources,
                   const Issues &issues) {
    sdf::Console::Instance()->SetQuiet(true);  // every error is thrown
    const SourceTree sources(text, file, resources);
    try {
        const sdf::ParserConfig config = parserConfig();
        const sdf::SDFPtr document = parse(sources, file, config, issues);
        nameFiles(document->Root(), sources);
        checkElements(document->Root(), file, issues);
        const sdf::Errors errors = m_root.Load(document, config);
        if (!errors.empty()) {
            const std::string message = errors.front().Message();
            throw toLoadError(message, placeOf(findFaultyElement(document->Root(), message, config), file));
        }
    } catch (const sdf::Exception &error) {  // no std::exception
        const std::string message = error.GetErrorStr();
        throw LoadError(LoadError::Kind::Syntax, sources.placeNamedIn(message), message);
    } catch (const std::logic_error &error) {  // out of libsdformat: of std::stoi, std::string ...
        throw LoadError(LoadError::Kind::Syntax, {file, "/sdf/world"},
                        std::string("libsdformat cannot read it: ") + error.what());
    }
    if (m_root.WorldCount() != 1)
        throw LoadError(LoadError::Kind::Unsupported, {file, "/sdf"}, "more than one <world>");
}

}  // namespace worlds
