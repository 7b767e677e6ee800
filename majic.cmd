@echo off
rem Starts MAJIC; builds what is missing or out of date first. See README.md, or majic --help.
setlocal
set "HERE=%~dp0"
set "JAR=%HERE%target\majic.jar"

set "JAVA=java.exe"
if exist "%JAVA_HOME%\bin\java.exe" set "JAVA=%JAVA_HOME%\bin\java.exe"
rem Java 8 does not know the option.
"%JAVA%" --version <nul >nul 2>nul
if errorlevel 1 (
  echo majic: a JDK 17 or newer is missing; type: winget install EclipseAdoptium.Temurin.21.JDK 1>&2
  exit /b 1
)
if not exist "%JAR%" goto build

rem PowerShell ends with 3 if a source is newer than the jar; with any other number the jar is used as it is.
powershell -NoProfile -NonInteractive -Command "$built = (Get-Item -LiteralPath $env:JAR).LastWriteTime; $sources = 'src\main', 'src\build', 'sims', 'pom.xml' | ForEach-Object { Join-Path $env:HERE $_ }; if (Get-ChildItem -LiteralPath $sources -Recurse | Where-Object { $_.LastWriteTime -gt $built } | Select-Object -First 1) { exit 3 }" <nul >nul 2>nul
if errorlevel 4 goto built
if errorlevel 3 goto build
goto built

:build
where mvn <nul >nul 2>nul
if errorlevel 1 (
  echo majic: Maven is missing; get it from maven.apache.org and put its bin folder on the PATH 1>&2
  exit /b 1
)
echo majic: building; the first time this fetches libraries and takes a minute or two 1>&2
pushd "%HERE%"
call mvn -q -B -Dmaven.test.skip -Dspotless.check.skip -Dcheckstyle.skip -Dmaven.javadoc.skip -Dmaven.source.skip package <nul
if errorlevel 1 (
  echo majic: the build failed 1>&2
  popd
  exit /b 1
)
rem A build that changes no class leaves the jar as it is; this gives it the time of now.
copy /b target\majic.jar+,, target\majic.jar >nul
popd

:built
if /i "%~1"=="package" goto package
if exist "%HERE%target\broker" goto start
for %%A in (%*) do if /i "%%~A"=="--broker" goto broker

:start
"%JAVA%" "@%HERE%config\java.options" -jar "%JAR%" %*
exit /b %ERRORLEVEL%

:broker
echo majic: fetching the embedded broker (100 MB) into target\broker, once; this takes a minute or more 1>&2
if exist "%HERE%target\broker.part" rmdir /s /q "%HERE%target\broker.part"
call mvn -q -B -Dmaven.wagon.rto=30000 -Daether.connector.requestTimeout=30000 -f "%HERE%src\build\broker\pom.xml" "-Dmajic.broker=%HERE%target\broker.part" package <nul >"%HERE%target\broker.log" 2>&1
if errorlevel 1 goto nobroker
ren "%HERE%target\broker.part" broker
goto start

:nobroker
echo majic: the embedded broker was not fetched; target\broker.log has the reason. Start MAJIC again to try again, or install another broker, such as Mosquitto 1>&2
goto start

:package
rem The dot keeps the backslash in front of it from quoting the quote.
"%JAVA%" -Djava.awt.headless=true -cp "%HERE%target\majic.jar" "%HERE%src\build\Packaging.java" "%HERE%."
exit /b %ERRORLEVEL%
