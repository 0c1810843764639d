@echo off
rem Runs SOFAS with the given arguments, on Java 17 or newer; bin/sofas for Windows.
setlocal
set "home=%~dp0.."
if defined SOFAS_JAVA (
    set "java=%SOFAS_JAVA%"
) else if defined JAVA_HOME (
    set "java=%JAVA_HOME%"
) else (
    set "java=java"
)
if exist "%java%\bin\java.exe" set "java=%java%\bin\java.exe"
set "options="
if "%~1"=="live" set "options=-XX:ThreadPriorityPolicy=1 -XX:-PrintWarnings"
"%java%" -XX:+UseSerialGC --enable-native-access=ALL-UNNAMED %options% %SOFAS_JAVA_OPTS% -cp "%home%\lib\*" io.github.sofas.cli.Main %*
exit /b %ERRORLEVEL%
