@echo off
rem Starts MAJIC; builds what is missing first. See README.md, or majic --help.
setlocal
set "HERE=%~dp0"
set "JAR=%HERE%target\majic.jar"

where java <nul >nul 2>nul || (
  echo majic: a JDK 17 or newer is missing; type: winget install EclipseAdoptium.Temurin.21.JDK 1>&2
  exit /b 1
)
if not exist "%JAR%" (
  where mvn <nul >nul 2>nul || (
    echo majic: Maven is missing; get it from maven.apache.org and put its bin folder on the PATH 1>&2
    exit /b 1
  )
  echo majic: building; the first time this fetches libraries and takes a minute or two 1>&2
  pushd "%HERE%"
  call mvn -q -B -DskipTests -Dspotless.check.skip -Dcheckstyle.skip -Dmaven.javadoc.skip -Dmaven.source.skip package <nul || (
    echo majic: the build failed 1>&2
    popd
    exit /b 1
  )
  popd
)
java "@%HERE%config\java.options" -jar "%JAR%" %*
exit /b %ERRORLEVEL%
