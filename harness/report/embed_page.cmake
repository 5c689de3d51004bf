# cmake -DFOLDER=… -DSTYLE=a.css -DSCRIPTS=a.js,b.js -DOUTPUT=… -P embed_page.cmake: the files as C++ strings.
function(read_as_literals variable)
  set(text "")
  foreach(name IN LISTS ARGN)
    file(READ ${FOLDER}/${name} content)
    string(APPEND text "R\"gcs_page(${content})gcs_page\"\n")
  endforeach()
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

string(REPLACE "," ";" SCRIPTS "${SCRIPTS}")
read_as_literals(style ${STYLE})
read_as_literals(script ${SCRIPTS})
file(WRITE ${OUTPUT} "#include \"harness/report/page_assets.hpp\"

namespace gcs {

const std::string_view page_style =
${style};
const std::string_view page_script =
${script};
}  // namespace gcs
")
