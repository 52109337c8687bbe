#pragma once

#include <string>

namespace ringlet {

/// An element <script ATTRIBUTES> that holds JSON or packed text for the code of a page. No text
/// can end it: `<` is written as JSON writes it.
std::string script_element(const std::string& attributes, std::string text);

/// Puts elements where the page has its mark <!--DATA-->. Throws Error if it has none.
std::string fill_page(const std::string& page, const std::string& elements);

}  // namespace ringlet
